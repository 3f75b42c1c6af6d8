#!/bin/bash
# usage: install-python-clones PYTHON [OPTION...] -- FOLDER...
# Has pip install, with the given options, those of the folders that hold a Python project, no package.xml and no project of
# CMake, beside what is there; colcon then passes them by. One that pip has installed from elsewhere is only passed by, but
# `--instead=FOLDER` takes the place of what pip has by that name: that was only guessed. What cannot be installed is told
# and stops nothing.
set -euo pipefail

pip=()
while [ "$1" != -- ]; do
  pip+=("$1")
  shift
done
shift
for each in "$@"; do
  folder="${each#--instead=}"
  if [ ! -f "${folder}/setup.py" ] && [ ! -f "${folder}/pyproject.toml" ]; then continue; fi
  if [ -f "${folder}/CMakeLists.txt" ] || [ -n "$(find "${folder}" -name package.xml -print -quit)" ]; then continue; fi
  touch "${folder}/COLCON_IGNORE"
  if [ "${each}" = "${folder}" ] && "${pip[0]}" -m pip show --quiet "$(basename "${folder}")" 2>/dev/null; then continue; fi
  echo "roslab: ${folder} has no package.xml: pip installs it with what it needs"
  install-optional-pip "${pip[@]}" -- "--no-build-isolation=${folder}"
  chown --recursive --reference="$(dirname "${folder}")" "${folder}"
done
