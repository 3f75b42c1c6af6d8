#!/bin/bash
# usage: leave-out-tests FOLDER...
# Tells colcon, which runs in the current folder, to compile no tests of the packages below the folders: those of sister
# packages are their authors' to run, and can take longer to compile than the packages. A folder may not be there: what
# cannot be cloned is left out.
set -euo pipefail

there=()
for folder in "$@"; do
  if [ -d "${folder}" ]; then there+=("${folder}"); fi
done
if [ "${#there[@]}" -eq 0 ]; then exit 0; fi
names="$(colcon list --names-only --base-paths "${there[@]}" | sort)"
{
  echo '{"names": {'
  sed --expression 's/.*/  "&": {"cmake-args": ["-DBUILD_TESTING=OFF"]}/' --expression '$!s/$/,/' <<<"${names}"
  echo '}}'
} >colcon.meta
