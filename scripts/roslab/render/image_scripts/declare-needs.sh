#!/bin/bash
# usage: declare-needs FOLDER
# Names in the package.xml files below a folder those packages of it that a CMakeLists.txt requires and its package.xml does
# not name: build tools order packages by these files alone, and CMake stops where one comes too late. Of packages that need
# each other none is named. To colcon, a project of CMake without a package.xml is a package of the project's name. What a
# package installs for CMake to find may be called otherwise than the package itself: its own NAMEConfig.cmake tells.
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

declare -A file_of=() needs=()
while read -r manifest; do
  name="$(read-manifest name "${manifest}")"
  if [ -z "${name}" ] || [ -e "$(dirname "${manifest}")/CATKIN_IGNORE" ]; then continue; fi
  file_of["${name}"]="${manifest}"
  needs["${name}"]=" $(read-manifest depends "${manifest}" | tr '\n' ' ') "
done < <(find "$1" -name .git -prune -o -name package.xml -print)

declare -A plain=()
while read -r made; do
  if [ -e "$(dirname "${made}")/package.xml" ]; then continue; fi
  name="$(sed --quiet --regexp-extended 's:^\s*project\s*\(\s*([A-Za-z0-9_.-]+).*:\1:Ip' "${made}" | sed 1q)"
  if [ -n "${name}" ]; then plain["${name}"]="${made}"; fi
done < <(find "$1" -name .git -prune -o -name CMakeLists.txt -xtype f -print)

declare -A bringing=()
while read -r made; do
  name="$(basename "${made}" | sed --regexp-extended 's:[.]in$::; s:-?[Cc]onfig[.]cmake$::')" folder="${made%/*}"
  while [ "${folder}" != "$1" ] && [ ! -e "${folder}/package.xml" ]; do folder="$(dirname "${folder}")"; done
  if [ ! -e "${folder}/package.xml" ] || [ -e "${folder}/CATKIN_IGNORE" ] || [ ! -f "${folder}/CMakeLists.txt" ]; then continue; fi
  if ! grep --quiet --extended-regexp "\b${name}-?[Cc]onfig[.]cmake" "${folder}/CMakeLists.txt"; then continue; fi
  bringing["${name}"]="$(read-manifest name "${folder}/package.xml")"
done < <(
  find "$1" -name .git -prune -o -regextype posix-extended \
    -regex '.*/[A-Za-z][A-Za-z0-9_]*(Config|-config)[.]cmake([.]in)?' -print
)

needs_in_turn() { # PACKAGE OTHER
  local queue=("$1") seen=' ' next
  while [ "${#queue[@]}" -gt 0 ]; do
    next="${queue[0]}" queue=("${queue[@]:1}")
    if [ "${next}" = "$2" ]; then return 0; fi
    if [ -z "${needs["${next}"]:-}" ] || [[ "${seen}" = *" ${next} "* ]]; then continue; fi
    seen="${seen}${next} "
    read -r -a more <<<"${needs["${next}"]}"
    queue+=("${more[@]}")
  done
  return 1
}
while read -r name; do
  manifest="${file_of["${name}"]}" made="$(dirname "${file_of["${name}"]}")/CMakeLists.txt"
  if [ ! -f "${made}" ]; then continue; fi
  for need in $(required-by-cmake "${made}"); do
    if [ -z "${file_of["${need}"]:-${plain["${need}"]:-}}" ]; then need="${bringing["${need}"]:-${need}}"; fi
    if [ "${need}" = "${name}" ]; then continue; fi
    if [ -z "${file_of["${need}"]:-${plain["${need}"]:-}}" ] || grep --quiet --extended-regexp ">\s*${need}\s*<" "${manifest}"; then continue; fi
    if needs_in_turn "${need}" "${name}"; then continue; fi
    sed --in-place "s:</package>:  <build_depend>${need}</build_depend>\n</package>:" "${manifest}"
    needs["${name}"]="${needs["${name}"]}${need} "
    echo "roslab: ${name} requires ${need}, which its package.xml does not name: it is named there"
  done
done < <(printf '%s\n' "${!file_of[@]}" | sort)
