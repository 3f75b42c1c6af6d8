#!/bin/bash
# usage: rosmake-workspace [--without=PACKAGE]... PACKAGE...
# Compiles packages of rosbuild (manifest.xml) below ./src, and writes the setup script that makes them known.
#   --without=PACKAGE  a package that this ROS no longer has: the manifests are told not to need it
set -euo pipefail

packages=()
for word in "$@"; do
  case "${word}" in
    --without=*) find src -name manifest.xml -exec sed --in-place --regexp-extended \
      "s#<depend +package=\"${word#--without=}\" */>##" {} + ;;
    *) packages+=("${word}") ;;
  esac
done
echo "export ROS_PACKAGE_PATH=\"${PWD}/src:\${ROS_PACKAGE_PATH}\"" >setup.bash
export ROS_PACKAGE_PATH="${PWD}/src:${ROS_PACKAGE_PATH}"
# Who compiles with cmake and make by hand has no Makefile: rosmake takes the one that most packages have
while IFS= read -r -d '' manifest; do
  folder="${manifest%/*}"
  if [ -e "${folder}/CMakeLists.txt" ] && [ ! -e "${folder}/Makefile" ]; then
    echo "include \$(shell rospack find mk)/cmake.mk" >"${folder}/Makefile"
  fi
done < <(find src -name manifest.xml -print0)
# To rosmake a manifest.xml with a name is catkin's, of which it builds nothing, without an error
find src -name manifest.xml -exec sed --in-place --null-data --regexp-extended 's#<name>[^<]*</name>##g' {} +
rosmake -V --status-rate=0 --threads=1 --pjobs="$(compile-jobs)" "${packages[@]}"
find src \( -name '*.o' -o -path '*/CMakeFiles/CMake*.log' \) -delete
