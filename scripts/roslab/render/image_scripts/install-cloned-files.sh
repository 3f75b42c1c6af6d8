#!/bin/bash
# usage: install-cloned-files PYTHON [OPTION...] -- FILE...
# Installs requirement files of repositories that the image cloned, with the given options. Nobody has read them before:
# where pip refuses one as a whole, its packages are installed one by one, and what fails is named and left out. A file
# that was not cloned is named too.
set -euo pipefail

pip=()
while [ "$1" != -- ]; do
  pip+=("$1")
  shift
done
shift
for file in "$@"; do
  if [ ! -e "${file}" ]; then
    echo "roslab: left out: ${file} was not cloned" >&2
  elif ! "${pip[0]}" -m pip install "${pip[@]:1}" --requirement "${file}"; then
    sed --regexp-extended 's/(^|[[:space:]]+)#.*//; s/^[[:space:]]+|[[:space:]]+$//g; /^(-.*)?$/d' "${file}" \
      | xargs --no-run-if-empty --delimiter='\n' install-optional-pip "${pip[@]}" --
  fi
done
