#!/bin/bash
# usage: install-optional-pip PYTHON [OPTION...] -- PACKAGE...
# Installs each package that pip finds, with the given options. The others are named and left out.
set -euo pipefail

pip=("$1" -m pip install --no-cache-dir)
shift
while [ "$1" != -- ]; do
  pip+=("$1")
  shift
done
shift
for package in "$@"; do
  "${pip[@]}" "${package}" || echo "pip ${package}" | tee --append /usr/local/share/roslab/left-out.txt
done
