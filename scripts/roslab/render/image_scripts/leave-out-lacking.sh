#!/bin/bash
# usage: leave-out-lacking PACKAGE FOLDER...
# Hides the packages in these folders where neither the workspace, in which it runs, nor ROS has the package that they
# require: a build tool stops there, and the others do without. A library of plain CMake that clone-holding noted is no package,
# and find_package finds it all the same; not so catkin, which looks for its components in workspaces alone.
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

name="$1"
shift
if [ -e "/opt/ros/${ROS_DISTRO}/share/${name}" ] || [ -n "$(workspace-packages needed src "${name}")" ]; then exit 0; fi
if grep --quiet --no-messages --line-regexp --fixed-strings "${name}" src/*/.git/roslab-plain &&
  grep --quiet --no-messages --ignore-case --extended-regexp "find_package *\\( *${name}\\b" "${@/%//CMakeLists.txt}"; then
  exit 0
fi
for folder in "$@"; do
  echo "roslab: left out: ${folder}, for nothing brings ${name}, which it requires"
  touch "${folder}/CATKIN_IGNORE" "${folder}/COLCON_IGNORE"
done
