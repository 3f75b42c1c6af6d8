#!/bin/bash
# usage: serve-rosbuild FOLDER
# Makes catkin know the packages of rosbuild (manifest.xml) below a folder, which it passes by: programs find their files by
# the package's name then. Nothing of them is compiled. Their own CMakeLists.txt is kept as CMakeLists.rosbuild.txt.
set -euo pipefail

while IFS= read -r -d '' manifest; do
  folder="${manifest%/*}" above="${manifest%/*}"
  if ! grep --quiet '<package' "${manifest}" || [ -n "$(find "${folder}" -name .git -prune -o -name package.xml -print -quit)" ]; then continue; fi
  while [ "${above}" != "$1" ] && [ "${above%/*}" != "${above}" ]; do
    above="${above%/*}"
    if [ -e "${above}/package.xml" ]; then continue 2; fi
  done
  name="$(basename "${folder}")"
  if [[ ! "${name}" =~ ^[A-Za-z][A-Za-z0-9_-]*$ ]]; then continue; fi
  if [ -e "${folder}/CMakeLists.txt" ]; then mv "${folder}/CMakeLists.txt" "${folder}/CMakeLists.rosbuild.txt"; fi
  printf 'cmake_minimum_required(VERSION 2.8.3...3.10)\nproject(%s)\nfind_package(catkin REQUIRED)\ncatkin_package()\n' \
    "${name}" >"${folder}/CMakeLists.txt"
  {
    echo "<package format=\"2\"><name>${name}</name><version>0.0.0</version><description>of rosbuild</description>"
    echo '<maintainer email="nobody@example.org">nobody</maintainer><license>unknown</license>'
    echo '<buildtool_depend>catkin</buildtool_depend></package>'
  } >"${folder}/package.xml"
  echo "roslab: ${name} is a package of rosbuild, which catkin does not compile: its files are found by its name"
done < <(find "$1" -name .git -prune -o -name manifest.xml -print0 | sort --zero-terminated)
