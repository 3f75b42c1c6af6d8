#!/bin/bash
# usage: install-plain-clones FOLDER...
# Compiles and installs those of the folders that hold a project of CMake and no package.xml: catkin passes these by. What
# cannot be compiled is told and stops nothing.
set -euo pipefail

left_out=/usr/local/share/roslab/left-out.txt
set +u # setup.bash reads variables that are not set
# shellcheck disable=SC1090 # a file of the image
source "/opt/ros/${ROS_DISTRO}/setup.bash" --
set -u
for folder in "$@"; do
  if [ ! -f "${folder}/CMakeLists.txt" ] || [ -n "$(find "${folder}" -name package.xml -print -quit)" ]; then continue; fi
  echo "roslab: ${folder} has no package.xml: it is compiled by CMake and installed to /usr/local"
  build="$(mktemp --directory)"
  if ! (cd "${build}" && configure-library -DCMAKE_BUILD_TYPE=Release "${folder}" && make --jobs="$(compile-jobs)" install); then
    echo "roslab: left out: $(basename "${folder}") cannot be compiled"
    echo "source $(basename "${folder}")" >>"${left_out}"
  fi
  rm -rf "${build}"
done
ldconfig
