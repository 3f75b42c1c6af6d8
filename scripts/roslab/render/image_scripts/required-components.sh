#!/bin/bash
# usage: required-components WORKSPACE
# Prints the names of the apt packages for what the CMakeLists.txt files of a workspace require and neither ROS nor the
# workspace has: components of catkin, packages of ROS 2, and libraries that the table of the image's Ubuntu names; and
# for the programs that they call (ExternalProject_Add with autoreconf, bison ...). What has no apt package is among them.
set -e # a search that finds nothing is no failure; not -u: an empty array is unset to the bash of Ubuntu 16.04

share="/opt/ros/${ROS_DISTRO}/share"
if [ ! -d "${share}" ]; then exit 0; fi
table="$(cat /usr/local/share/roslab/cmake-*.txt)"
own="$(
  find "$1" -name .git -prune -o -name package.xml -exec read-manifest name {} +
  find "$1" -name .git -prune -o -name CMakeLists.txt -xtype f -exec \
    sed --quiet --regexp-extended 's:^[[:space:]]*project[[:space:]]*\([[:space:]]*([A-Za-z0-9_.+-]+).*:\1:Ip' {} +
)"

of_ros() { echo "ros-${ROS_DISTRO}-${1//_/-}"; }
known() { apt-cache show "$1" >/dev/null 2>&1; }
# Of what is compiled from its source already, nothing is installed
installed() {
  [ -n "$(find /usr/local/lib /usr/local/share -iname "$1config.cmake" -o -iname "$1-config.cmake" 2>/dev/null)" ]
}

# What catkin and colcon pass by is not compiled
marked=()
while read -r path; do marked+=(-path "${path}" -o); done < <(
  find "$1" -regextype posix-extended -regex '.*/(AMENT|CATKIN|COLCON)_IGNORE' -printf '%h\n'
)
files=/tmp/required-components
find "$1" \( "${marked[@]}" -name .git \) -prune -o -name CMakeLists.txt -xtype f -print0 >"${files}"
for what in '' --programs; do xargs --null --no-run-if-empty required-by-cmake ${what} <"${files}"; done |
  while read -r name; do
    if [ -e "${share}/${name}" ] || installed "${name}"; then continue; fi
    if grep --quiet --ignore-case --line-regexp --fixed-strings "${name}" <<<"${own}"; then continue; fi
    if [[ "${name}" =~ ^[a-z][a-z0-9_]*$ ]] && known "$(of_ros "${name}")"; then
      of_ros "${name}"
      continue
    fi
    read -r -a packages < <(
      awk -F' = ' -v name=" ${name,,} " 'index(" " $1 " ", name) { print $2 }' <<<"${table}"
    ) || packages=()
    if [[ "${packages[0]:-}" = ros:* ]]; then
      ros="${packages[0]#ros:}" packages=("${packages[@]:1}")
      if [ -e "${share}/${ros}" ]; then continue; fi
      if known "$(of_ros "${ros}")"; then packages=("$(of_ros "${ros}")"); fi
    fi
    if [ "${#packages[@]}" -gt 0 ]; then
      printf '%s\n' "${packages[@]}"
    elif [[ "${name}" =~ ^[a-z][a-z0-9_]*$ ]]; then
      of_ros "${name}"
    fi
  done | LC_ALL=C sort --unique
rm "${files}"
