#!/bin/bash
# usage: install-optional-pip PYTHON [OPTION...] -- PACKAGE...
# Installs each package that pip finds, with the given options. Of one that has not the exact version which a page names,
# another version is taken. The others are named and left out.
set -euo pipefail

pip=("$1" -m pip install)
shift
while [ "$1" != -- ]; do
  pip+=("$1")
  shift
done
shift
for package in "$@"; do
  if "${pip[@]}" "${package}"; then continue; fi
  name="${package%%==*}"
  if [ "${name}" != "${package}" ] && "${pip[@]}" "${name}"; then
    echo "roslab: pip cannot install ${package} here: another version is taken" >&2
    continue
  fi
  echo "pip ${package}" | tee --append /usr/local/share/roslab/left-out.txt
done
