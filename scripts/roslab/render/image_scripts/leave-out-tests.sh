#!/bin/bash
# usage: leave-out-tests FOLDER...
# Tells colcon, which runs in the current folder, to compile no tests of the packages below the folders: those of sister
# packages are their authors' to run, and can take longer to compile than the packages.
set -euo pipefail

names="$(colcon list --names-only --base-paths "$@" | sort)"
{
  echo '{"names": {'
  sed --expression 's/.*/  "&": {"cmake-args": ["-DBUILD_TESTING=OFF"]}/' --expression '$!s/$/,/' <<<"${names}"
  echo '}}'
} >colcon.meta
