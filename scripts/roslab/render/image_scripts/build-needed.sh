#!/bin/bash
# usage: build-needed [--keep PACKAGE]... FOLDER COMMAND...
# Runs a command that builds the workspace in the current folder. Where it fails, it is run once more without the packages
# of cloned repositories that the repository in FOLDER does not need: a clone is compiled whole, often for one package.
# Needed is what its build files, code or launch files name, what is kept, and what these need in turn.
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

kept=()
while [ "$1" = --keep ]; do
  kept+=("$2")
  shift 2
done
own="$1"
shift

if "$@"; then exit 0; fi

tag() { sed --quiet --regexp-extended "s:.*<($2)( [^>]*)?>[[:space:]]*([^<]*[^<[:space:]])[[:space:]]*<.*:\3:p" "$1"; }
declare -A file_of=() needed=()
while read -r manifest; do
  name="$(tag "${manifest}" name | head -n 1)"
  if [ -n "${name}" ]; then file_of["${name}"]="${manifest}"; fi
done < <(find src -name .git -prune -o -path "${own}" -prune -o -name package.xml -print)
mapfile -t queue < <(
  grep --recursive --no-filename --only-matching --extended-regexp '[A-Za-z][A-Za-z0-9_-]+' "${own}" \
    --include={package.xml,CMakeLists.txt,'*.'{cmake,launch,xml,xacro,urdf,py,yaml,rviz,c,cc,cpp,cxx,h,hh,hpp,msg,srv,action}} |
    sort --unique
)
queue+=("${kept[@]}")
while [ "${#queue[@]}" -gt 0 ]; do
  found=()
  for name in "${queue[@]}"; do
    manifest="${file_of["${name}"]:-}"
    if [ -z "${manifest}" ] || [ -n "${needed["${name}"]:-}" ]; then continue; fi
    needed["${name}"]=yes
    mapfile -t depends < <(tag "${manifest}" '[a-z_]*depend')
    found+=("${depends[@]}")
  done
  queue=("${found[@]}")
done

left_out=()
for name in "${!file_of[@]}"; do
  here="$(dirname "${file_of["${name}"]}")"
  if [ -n "${needed["${name}"]:-}" ] || [ -e "${here}/CATKIN_IGNORE" ]; then continue; fi
  for other in "${!needed[@]}"; do
    if [[ "$(dirname "${file_of["${other}"]}")/" = "${here}/"* ]]; then continue 2; fi # the marker would hide it
  done
  touch "${here}/CATKIN_IGNORE" "${here}/COLCON_IGNORE"
  left_out+=("${name}")
done
if [ "${#left_out[@]}" -eq 0 ]; then exit 1; fi
mapfile -t left_out < <(printf '%s\n' "${left_out[@]}" | sort)
echo "roslab: the workspace does not build: once more without packages of cloned repositories that nothing here needs"
echo "roslab: left out: ${left_out[*]}"
"$@"
