#!/bin/bash
# usage: clone-listed [--ros1|--ros2] [--rosmake] [--plain] [--ref REF] [--branch BRANCH] [--before DAY] URL FOLDER
# Clones to a folder of the workspace, as its owner's, a repository that a list or a page names. Where its host asks for a
# password or has no such repository, or no longer speaks to a git as old as that of Ubuntu 14.04, it is named and left out;
# what else fails stops the build. Submodules that cannot be fetched are left out, one by one.
# Of one in which the workspace finds nothing to build, that is told.
#   --ros1, --ros2   for a workspace of that ROS: where all its packages are of the other, a branch for it is taken if there is one
#   --rosmake        for a workspace of rosbuild; else catkin is told the names of what has a manifest.xml alone
#   --plain          it is compiled by CMake where it has no package.xml
#   --ref REF        a tag or commit
#   --branch BRANCH  a branch, which may be gone; for that of another distribution (kinetic-devel) its own is taken, if there is one
#   --before DAY     the newest commit not after this day (YYYY-MM-DD)
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

ref='' branch='' day='' ros='' plain='' rosmake=''
while [[ "$1" = --* ]]; do
  case "$1" in
    --ros[12])
      ros="${1#--ros}"
      shift
      continue
      ;;
    --plain | --rosmake)
      if [ "$1" = --plain ]; then plain=yes; else rosmake=yes; fi
      shift
      continue
      ;;
    --ref) ref="$2" ;;
    --branch) branch="$2" ;;
    --before) day="$2" ;;
  esac
  shift 2
done
url="$1" folder="$2" share=/usr/local/share/roslab
refused='could not read (Username|Password)|Authentication failed|[Rr]epository not found|repository .* not found'
refused+='|Permission denied \(|could not be found or you don.t have permission'
why='its host asks for a password, or has it no longer'
if [[ "$(git --version 2>/dev/null)" = 'git version 1.'* ]]; then
  refused+='|gnutls_handshake\(\) failed|server certificate verification failed|SSL certificate problem'
  why+=', or does not speak to a git this old'
fi
# Nobody is there to give a password
export GIT_TERMINAL_PROMPT=0 LC_ALL=C

# Runs git; ends with 1 where the host refuses, and ends the script where something else fails
try() {
  local said status=0
  said="$(git "$@" 2>&1)" || status=$?
  printf '%s\n' "${said}" >&2
  if [ "${status}" -eq 0 ]; then return 0; fi
  if grep --quiet --extended-regexp "${refused}" <<<"${said}"; then return 1; fi
  exit "${status}"
}

leave_out() { # WHAT
  echo "roslab: left out: $1: ${why}"
  if [ -w "${share}" ]; then echo "source $1" >>"${share}/left-out.txt"; fi
}

if ! try clone "${url}" "${folder}"; then
  leave_out "${url}"
  rm -rf "${folder}"
  exit 0
fi
own="${ROS_DISTRO:-}-devel"
if [[ "${branch}" =~ ^[a-z]+-devel$ && "${branch}" != "${own}" ]] &&
  git -C "${folder}" rev-parse --quiet --verify "origin/${own}" >/dev/null; then
  echo "roslab: ${url} has a branch ${own}: it is taken for ${branch}, which is another distribution's"
  branch="${own}"
fi
if [ -n "${branch}" ]; then
  checkout-branch "${folder}" "${branch}"
elif [ -n "${ref}" ]; then
  git -C "${folder}" -c advice.detachedHead=false checkout "${ref}"
fi

if [ -n "${day}" ]; then
  commit="$(git -C "${folder}" rev-list --max-count=1 --first-parent --before="${day}T23:59:59Z" HEAD)"
  git -C "${folder}" -c advice.detachedHead=false checkout --quiet "${commit:-HEAD}" --
fi
if [ -n "${ros}" ]; then take-ros-branch "${ros}" "${url}" "${folder}" "${day}"; fi
fetch-submodules "${folder}"
lacks() { [ -z "$(find "${folder}" -name .git -prune -o \( "$@" \) -print -quit)" ]; }
if [ "${ros}" = 1 ] && [ -z "${rosmake}" ] && lacks -name package.xml && ! lacks -name manifest.xml; then
  serve-rosbuild "${folder}"
fi
manifests=(-name package.xml -o -name manifest.xml)
if [ "${ros}" = 2 ]; then manifests=(-name package.xml -o -name CMakeLists.txt -o -name setup.py); fi
if [ -n "${ros}" ] && lacks "${manifests[@]}"; then
  at="$(git -C "${folder}" rev-parse --quiet --verify --short HEAD || echo 'no commit')"
  said="${url} has no package at ${at}, so that the workspace builds none of it"
  if [ -n "${plain}" ] && [ -f "${folder}/CMakeLists.txt" ]; then
    said+=": it is compiled by CMake as a library; where CATKIN_DEPENDS names it, another repository is meant, for catkin"
    said+=" takes packages alone there"
  elif [ -f "${folder}/CMakeLists.txt" ]; then
    said+=": if it is a library, give it under source in roslab.yaml, with build: cmake"
  fi
  echo "roslab: ${said}"
fi
chown --recursive --reference="$(dirname "${folder}")" "${folder}"
