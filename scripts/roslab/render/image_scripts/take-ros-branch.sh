#!/bin/bash
# usage: take-ros-branch 1|2 URL FOLDER [DAY]
# Where all packages of the clone of URL in FOLDER are of the other ROS, checks a branch for this one out, if there is one: of
# a usual name, or whose last part is the distribution's (feature/noetic). Which one is told. Where there is none, build tools
# pass the clone by, unless a CMakeLists.txt of it calls the macros of this ROS.
#   DAY  the newest commit not after this day (YYYY-MM-DD)
set -eo pipefail

ros="$1" url="$2" folder="$3" day="${4:-}"
of_day() { # BRANCH
  if [ -z "${day}" ]; then
    echo "$1"
    return
  fi
  commit="$(git -C "${folder}" rev-list --max-count=1 --first-parent --before="${day}T23:59:59Z" "$1")"
  echo "${commit:-$1}"
}
calls() { git -C "${folder}" grep --quiet --ignore-case --extended-regexp "$1" HEAD -- CMakeLists.txt '*/CMakeLists.txt'; }
has() { git -C "${folder}" grep --quiet --extended-regexp "$1" "$2" -- 'package.xml' '*/package.xml'; }
catkin='<buildtool_depend[^>]*>\s*catkin' ament='ament|<build_type>\s*cmake'
if [ "${ros}" = 1 ]; then
  ours="${catkin}" theirs=ament macros='catkin_(package|simple|metapackage)'
else
  ours="${ament}" theirs="${catkin}" macros='ament_(auto_)?package'
fi
if ! has "${theirs}" HEAD || has "${ours}" HEAD; then exit 0; fi
said="${url} has packages of ROS $((3 - ros)) alone at $(git -C "${folder}" rev-parse --short HEAD)"
named=("ros${ros}" ${ROS_DISTRO:+"${ROS_DISTRO}" "${ROS_DISTRO}-devel" "ros${ros}-${ROS_DISTRO}"} "ros${ros}-devel" "ros${ros}-master")
if [ -n "${ROS_DISTRO:-}" ]; then
  mapfile -t below < <(git -C "${folder}" for-each-ref --format='%(refname:strip=3)' refs/remotes/origin |
    grep --extended-regexp "/${ROS_DISTRO}$" || true)
  named+=("${below[@]}")
fi
for other in "${named[@]}"; do
  if ! git -C "${folder}" rev-parse --quiet --verify "origin/${other}" >/dev/null; then continue; fi
  at="$(of_day "origin/${other}")"
  if has "${ours%%|*}" "${at}"; then
    git -C "${folder}" -c advice.detachedHead=false checkout --quiet "${at}" --
    echo "roslab: ${said}: its branch ${other} is taken"
    exit 0
  fi
done
echo "roslab: ${said}, and no branch for ROS ${ros}: what needs it cannot be built"
if ! calls "${macros}"; then touch "${folder}/CATKIN_IGNORE" "${folder}/COLCON_IGNORE"; fi
