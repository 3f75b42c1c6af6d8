#!/bin/bash
# usage: clone-holding [--ros1|--ros2] [--rosmake] [--ref REF] [--branch BRANCH] [--before DAY] URL FOLDER PACKAGE... [--also PACKAGE...]
# Clones to a folder of the workspace a repository that may hold packages which nothing else brings. What does not answer,
# or holds none of those that the workspace lacks, is named and left out. Of the others in it, only those that these need
# are compiled. A project of CMake without any package.xml that is called so is kept, too, or one with a Makefile that
# installs it: install-plain-clones knows it by what is noted in its folder of git. A PACKAGE may be a module of Python, too:
# a repository with its folder, or its file beside a setup.py, is kept, and the user's Python looks there.
#   --ros1, --ros2   for a workspace of that ROS: where all its packages are of the other, a branch for it is taken if there is one
#   --rosmake        for a workspace of rosbuild, whose packages have a manifest.xml; catkin only learns their names
#   --ref REF        a branch, tag or commit
#   --branch BRANCH  a branch, which may be gone
#   --before DAY     the newest commit not after this day (YYYY-MM-DD); a tag or commit stays as it is
#   --also           other packages that nothing else brings: they are taken, too, where it is cloned for the first ones
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

ref='' branch='' day='' ros='' rosmake=''
while [[ "$1" = --* ]]; do
  case "$1" in
    --ros[12])
      ros="${1#--ros}"
      shift
      continue
      ;;
    --rosmake)
      rosmake=yes
      shift
      continue
      ;;
    --ref) ref="$2" ;;
    --branch) branch="$2" ;;
    --before) day="$2" ;;
  esac
  shift 2
done
url="$1" folder="$2" workspace="$(dirname "$2")"
shift 2
packages=() also=()
while [ "$#" -gt 0 ]; do
  if [ "$1" = --also ]; then
    also=("${@:2}")
    break
  fi
  packages+=("$1")
  shift
done
set -- "${packages[@]}"
leave_out() {
  echo "roslab: left out: ${url}: $1"
  rm -rf "${folder}"
  exit 0
}
if [ -d "${workspace}" ]; then # a clone of before may have one, hidden because nothing needed it then
  workspace-packages show "${workspace}" "$@" "${also[@]}" | sed 's/^/roslab: no longer hidden: /'
fi
lacks() {
  if [ ! -d "${workspace}" ]; then return 0; fi
  if [ -n "${rosmake}" ] && [ -n "$(find "${workspace}" -path "*/$1/manifest.xml" -print -quit)" ]; then return 1; fi
  if grep --quiet --no-messages --line-regexp --fixed-strings "$1" "${workspace}"/*/.git/roslab-{plain,modules}; then return 1; fi
  [ -z "$(workspace-packages needed "${workspace}" "$1")" ]
}
lacking=()
for package in "$@"; do
  if lacks "${package}"; then lacking+=("${package}"); fi
done
if [ "${#lacking[@]}" -eq 0 ]; then
  echo "roslab: ${url} is not needed: the workspace has $*"
  exit 0
fi

for package in "${also[@]}"; do
  if lacks "${package}"; then lacking+=("${package}"); fi
done

# Where a host has no such repository it asks for a password, which nobody is there to give
export GIT_TERMINAL_PROMPT=0
if ! git clone "${url}" "${folder}"; then # what is called x_y here may be x-y there
  name="$(basename "${url}")"
  if [[ "${name}" != *_* ]]; then leave_out "it cannot be cloned"; fi
  git clone "${url%/*}/${name//_/-}" "${folder}" || leave_out "it cannot be cloned, and no ${name//_/-} either"
fi
if [ -n "${ref}" ]; then
  git -C "${folder}" -c advice.detachedHead=false checkout "${ref}" || leave_out "it has no ${ref}"
fi
if [ -n "${branch}" ]; then checkout-branch "${folder}" "${branch}"; fi
if [ -n "${day}" ] && { [ -z "${ref}" ] || git -C "${folder}" rev-parse --quiet --verify "refs/remotes/origin/${ref}" >/dev/null; }; then
  commit="$(git -C "${folder}" rev-list --max-count=1 --first-parent --before="${day}T23:59:59Z" HEAD)"
  git -C "${folder}" -c advice.detachedHead=false checkout "${commit:-HEAD}"
fi
if [ -n "${ros}" ] && [ -z "${ref}${branch}" ]; then take-ros-branch "${ros}" "${url}" "${folder}" "${day}"; fi
look() { mapfile -t kept < <(workspace-packages needed "${folder}" "${lacking[@]}" | cut --fields=1); }
# Tells whether a submodule may hold one: it shares a word with it, or all packages of the repository are in submodules
beneath() {
  if [ ! -e "${folder}/.gitmodules" ]; then return 1; fi
  if [ -z "$(find "${folder}" -name .git -prune -o -name package.xml -print -quit)" ]; then return 0; fi
  local package words common='msgs|srvs|drivers?|common|robot|core|tools|utils|interfaces'
  for package in "${lacking[@]}"; do
    words="$(tr '_-' '\n' <<<"${package}" | grep '....' | grep --invert-match --line-regexp --extended-regexp "${common}" || true)"
    if grep --quiet --ignore-case --fixed-strings --regexp="${words:-${package}}" "${folder}/.gitmodules"; then
      return 0
    fi
  done
  return 1
}
# Prints those that a plain project of CMake is called, or by which it has itself found, or a repository with a Makefile
plain() {
  if [ -n "$(find "${folder}" -name .git -prune -o -name package.xml -print -quit)" ]; then return; fi
  local package called
  if [ ! -f "${folder}/CMakeLists.txt" ]; then
    if ! grep --quiet --no-messages '^install *:' "${folder}/Makefile"; then return; fi
    for package in "${lacking[@]}"; do
      if [ "$(basename "${url}" .git)" = "${package}" ]; then echo "${package}"; fi
    done
    return
  fi
  called="$({ sed 's/#.*//' "${folder}/CMakeLists.txt" | tr '\n\t\r"' '    ' |
    grep --only-matching --ignore-case --extended-regexp '(^|[ )])project *\( *[A-Za-z0-9_.+-]+' || true; } | sed --quiet '1s/.*[( ]//p')"
  for package in "${lacking[@]}"; do
    if [ "$(tr '_-' '  ' <<<"${called,,}")" = "$(tr '_-' '  ' <<<"${package,,}")" ] ||
      [ -n "$(find "${folder}" -name .git -prune -o \( -iname "${package}config.cmake*" -o -iname "${package}-config.cmake*" \) -print -quit)" ]; then
      echo "${package}"
    fi
  done
}
# Has Python find those that are its modules, outside of packages of ROS, and notes them
modules() {
  local package file python site
  for package in "${lacking[@]}"; do
    file="$(find "${folder}" \( -name .git -o -type d -exec test -e '{}/package.xml' ';' \) -prune \
      -o -path "*/${package}/__init__.py" -printf '%d %h\n' \
      -o -name "${package}.py" -execdir test -e setup.py ';' -printf '%d %p\n' |
      sort --numeric-sort | sed --quiet '1s/^[0-9]* //p')"
    if [ -z "${file}" ]; then continue; fi
    echo "${package}" | tee --append "${folder}/.git/roslab-modules"
    for python in python2 python3; do
      site="$("${python}" -m site --user-site 2>/dev/null || true)"
      if [ -z "${site}" ]; then continue; fi
      mkdir --parents "${site}"
      dirname "${file}" >>"${site}/roslab.pth"
    done
  done
}
# Prints those that are packages of rosbuild
of_rosbuild() {
  local package
  for package in "${lacking[@]}"; do
    if [ -n "$(find "${folder}" -name .git -prune -o -path "*/${package}/manifest.xml" -print -quit)" ]; then echo "${package}"; fi
  done
}
look
mapfile -t old < <(if [ "${ros}" = 1 ]; then of_rosbuild; fi)
if [ "${#kept[@]}" -eq 0 ] && [ "${#old[@]}" -gt 0 ]; then
  if [ -n "${rosmake}" ]; then
    fetch-submodules "${folder}"
    echo "roslab: ${url} brings ${old[*]}"
    exit 0
  fi
  serve-rosbuild "${folder}"
  look
fi
mapfile -t plain < <(plain)
if [ "${#kept[@]}" -eq 0 ] && [ "${#plain[@]}" -gt 0 ]; then
  fetch-submodules "${folder}"
  printf '%s\n' "${plain[@]}" >"${folder}/.git/roslab-plain"
  echo "roslab: ${url} is ${plain[*]}, a library without a package.xml"
  exit 0
fi
mapfile -t modules < <(modules)
if [ "${#modules[@]}" -gt 0 ]; then echo "roslab: ${url} brings ${modules[*]}, for Python"; fi
if [ "${#kept[@]}" -gt 0 ] || beneath; then
  fetch-submodules "${folder}"
  look
fi
if [ "${#kept[@]}" -eq 0 ] && [ "${#modules[@]}" -eq 0 ]; then leave_out "it holds no package called ${lacking[*]}"; fi
if [ "${#kept[@]}" -gt 0 ]; then echo "roslab: ${url} brings ${kept[*]}"; fi
workspace-packages hide "${folder}" "${kept[@]}" >/dev/null
