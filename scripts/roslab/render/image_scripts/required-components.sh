#!/bin/bash
# usage: required-components WORKSPACE
# Prints the names of the apt packages for what the CMakeLists.txt files of a workspace require of ROS and neither ROS nor
# the workspace has: components of catkin, and packages of ROS 2. What has no apt package is among them.
set -eu # a search that finds nothing is no failure

share="/opt/ros/${ROS_DISTRO}/share"
if [ ! -d "${share}" ]; then exit 0; fi
own="$(
  find "$1" -name .git -prune -o -name package.xml -exec \
    sed --quiet --regexp-extended 's:.*<name>[[:space:]]*([^<[:space:]]+)[[:space:]]*</name>.*:\1:p' {} +
)"
find "$1" -name .git -prune -o -name CMakeLists.txt -print0 | xargs --null --no-run-if-empty required-by-cmake |
  while read -r name; do
    if [ ! -e "${share}/${name}" ] && ! grep --quiet --line-regexp --fixed-strings "${name}" <<<"${own}"; then
      echo "ros-${ROS_DISTRO}-${name//_/-}"
    fi
  done
