#!/bin/bash
# usage: install-plain-clones [--in WORKSPACE] [FOLDER...]
# Compiles and installs those of the folders that hold a project of CMake and no package.xml: catkin passes these by. What
# cannot be compiled before another one is installed is tried again behind it; else it is told and stops nothing.
#   --in WORKSPACE  also those folders in it that clone-holding noted as such, which may have a Makefile alone, and colcon
#                   passes them by then
set -euo pipefail

left_out=/usr/local/share/roslab/left-out.txt
set +u # setup.bash reads variables that are not set
# shellcheck disable=SC1090 # a file of the image
source "/opt/ros/${ROS_DISTRO}/setup.bash" --
set -u
if [ "${1:-}" = --in ]; then
  shopt -s nullglob
  for noted in "$2"/*/.git/roslab-plain; do
    set -- "$@" "${noted%/.git/roslab-plain}"
  done
  shift 2
fi
todo=()
for folder in "$@"; do
  if { [ ! -f "${folder}/CMakeLists.txt" ] && [ ! -e "${folder}/.git/roslab-plain" ]; } || [ -n "$(find "${folder}" -name package.xml -print -quit)" ]; then continue; fi
  if [[ " ${todo[*]-} " = *" ${folder} "* ]]; then continue; fi # it is noted and named
  if [ -e "${folder}/.git/roslab-plain" ]; then touch "${folder}/COLCON_IGNORE"; fi
  by=CMake
  if [ ! -f "${folder}/CMakeLists.txt" ]; then by='its Makefile'; fi
  echo "roslab: ${folder} has no package.xml: it is compiled by ${by} and installed to /usr/local"
  todo+=("${folder}")
done
installed() {
  local build status=0
  build="$(mktemp --directory)"
  if [ ! -f "$1/CMakeLists.txt" ]; then
    (cp --archive "$1/." "${build}" && cd "${build}" && make --jobs="$(compile-jobs)" && make install) || status=$?
    rm -rf "${build}"
    return "${status}"
  fi
  (cd "${build}" && configure-library -DCMAKE_BUILD_TYPE=Release "$1" && warnings-pass "$1" make --jobs="$(compile-jobs)" install) || status=$?
  rm -rf "${build}"
  return "${status}"
}
before=-1
while [ "${#todo[@]}" -gt 0 ] && [ "${#todo[@]}" -ne "${before}" ]; do
  before="${#todo[@]}" failed=()
  for folder in "${todo[@]}"; do
    if installed "${folder}"; then ldconfig; else failed+=("${folder}"); fi
  done
  todo=(${failed[@]+"${failed[@]}"})
  if [ "${before}" -eq 1 ]; then break; fi # there is no other one
done
for folder in ${todo[@]+"${todo[@]}"}; do
  rm -f "${folder}/.git/roslab-plain" # what requires it lacks it
  echo "roslab: left out: $(basename "${folder}") cannot be compiled"
  echo "source $(basename "${folder}")" >>"${left_out}"
done
ldconfig
