#!/bin/bash
# usage: raise-standard STANDARD NAMES FOLDER... [--but FOLDER]
# Raises the standard of C++ that CMake files of a workspace's packages below the folders, but not below the last one, name,
# where it is older: 14 for -std=c++11 and CMAKE_CXX_STANDARD 11. So for packages that need a library of these names, or
# include its headers, and for packages that need one of these in turn: its headers refuse older standards.
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

standard="$1" names="$2" folders=() but=''
shift 2
while [ $# -gt 0 ]; do
  if [ "$1" = --but ]; then but="$2" && shift; else folders+=("$1"); fi
  shift
done
case "${standard}" in
  14) older='98|03|0x|11' ;;
  17) older='98|03|0x|11|1y|14' ;;
  *) echo "raise-standard: ${standard} is no standard that is known here" >&2 && exit 2 ;;
esac
included="^[[:space:]]*#[[:space:]]*include[[:space:]]*[<\"](${names// /|})/"

declare -A file_of=() needs=() raised=()
while read -r manifest; do
  name="$(read-manifest name "${manifest}")" here="$(dirname "${manifest}")"
  if [ -z "${name}" ] || [ ! -f "${here}/CMakeLists.txt" ] || [ -e "${here}/CATKIN_IGNORE" ]; then continue; fi
  file_of["${name}"]="${manifest}"
  needs["${name}"]=" $({ read-manifest depends "${manifest}" && required-by-cmake "${here}/CMakeLists.txt"; } | tr '\n' ' ') "
  if grep --quiet --recursive --extended-regexp --include='*.h' --include='*.hpp' --include='*.c*' "${included}" "${here}"; then
    needs["${name}"]+="${names} "
  fi
done < <(find src -name .git -prune -o -name package.xml -print)

queue="${names}"
while [ -n "${queue}" ]; do
  more=''
  for name in "${!file_of[@]}"; do
    if [ -n "${raised["${name}"]}" ]; then continue; fi
    for need in ${queue}; do
      if [[ "${needs["${name}"]}" = *" ${need} "* ]]; then
        raised["${name}"]=yes more="${more} ${name}"
        break
      fi
    done
  done
  queue="${more}"
done

while read -r name; do
  here="$(dirname "${file_of["${name}"]}")" inside=''
  for folder in "${folders[@]}"; do
    if [[ "${here}/" = "${folder}/"* ]]; then inside=yes; fi
  done
  if [ -z "${inside}" ] || [[ -n "${but}" && "${here}/" = "${but}/"* ]]; then continue; fi
  mapfile -t files < <(
    grep --recursive --files-with-matches --extended-regexp --exclude-dir=.git --include=CMakeLists.txt --include='*.cmake' \
      -e "-std=(c|gnu)[+][+](${older})\>|\<(CMAKE_)?CXX_STANDARD[[:space:]]+(${older})\>|\<cxx_std_(${older})\>" "${here}"
  )
  if [ "${#files[@]}" -eq 0 ]; then continue; fi
  sed --in-place --regexp-extended \
    -e "s/(-std=(c|gnu)[+][+])(${older})\>/\1${standard}/g" \
    -e "s/(\<(CMAKE_)?CXX_STANDARD[[:space:]]+)(${older})\>/\1${standard}/g" \
    -e "s/(\<cxx_std_)(${older})\>/\1${standard}/g" "${files[@]}"
  echo "roslab: ${name} is compiled as C++${standard}, which a library that it needs asks for"
done < <(printf '%s\n' "${!raised[@]}" | grep . | sort)
