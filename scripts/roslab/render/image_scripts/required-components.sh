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
asked() {
  local file code
  while read -r file; do
    code="$(sed 's/#.*//' "${file}" | tr '\n' ' ')"
    grep --only-matching --ignore-case --extended-regexp 'find_package *\( *catkin [^)]*' <<<"${code}" |
      sed --quiet --regexp-extended 's/.*COMPONENTS//p' | tr -s ' \t' '\n'
    grep --only-matching --ignore-case --extended-regexp 'find_package *\( *[a-z][a-z0-9_]* +REQUIRED *\)' <<<"${code}" |
      sed --regexp-extended 's/.*\( *([a-z0-9_]+).*/\1/'
  done < <(find "$1" -name .git -prune -o -name CMakeLists.txt -print)
}
asked "$1" | grep --line-regexp --extended-regexp '[a-z][a-z0-9_]*' | grep --line-regexp --invert-match catkin | sort --unique |
  while read -r name; do
    if [ ! -e "${share}/${name}" ] && ! grep --quiet --line-regexp --fixed-strings "${name}" <<<"${own}"; then
      echo "ros-${ROS_DISTRO}-${name//_/-}"
    fi
  done
