#!/bin/bash
# usage: leave-out-doubles [--beside MANIFESTS] FOLDER...
# Hides the packages in these folders of a workspace, which were cloned, that the rest of it has too, or a folder before:
# a build tool stops where two packages have one name, and so does rosdep. It runs in the workspace.
#   --beside MANIFESTS  the packages below this folder will lie in the workspace, too
set -euo pipefail

beside=''
if [ "${1:-}" = --beside ]; then
  beside="$(realpath --canonicalize-missing "$2")"
  beside="${beside#"$(pwd -P)/"}" # spelled as the folders of the workspace are
  shift 2
fi

# Lists the packages below a folder that a build tool finds: not those inside another, nor those that a marker hides
packages() {
  local manifest folder above name
  while read -r manifest; do
    folder="${manifest%/package.xml}" above="${manifest%/*}"
    while [ -n "${above}" ]; do
      if [ -e "${above}/CATKIN_IGNORE" ] || [ -e "${above}/COLCON_IGNORE" ]; then continue 2; fi
      if [ "${above}" != "${folder}" ] && [ -e "${above}/package.xml" ]; then continue 2; fi
      if [[ "${above}" != */* ]]; then break; fi
      above="${above%/*}"
    done
    name="$(read-manifest name "${manifest}")"
    if [ -n "${name}" ]; then printf '%s\t%s\n' "${name}" "${folder}"; fi
  done < <(find "$1" -name .git -prune -o -name package.xml -print | sort)
}

declare -A seen=()
while IFS=$'\t' read -r name folder; do
  for cloned in "$@"; do
    if [[ "${folder}/" = "${cloned}/"* ]]; then continue 2; fi
  done
  seen["${name}"]="${folder}"
done < <(
  packages src
  if [ -n "${beside}" ]; then packages "${beside}"; fi
)
for cloned in "$@"; do
  if [ ! -d "${cloned}" ]; then continue; fi
  mapfile -t found < <(packages "${cloned}")
  if [ "${#found[@]}" -eq 0 ]; then continue; fi
  for each in "${found[@]}"; do
    name="${each%%$'\t'*}" folder="${each#*$'\t'}"
    if [ -z "${seen["${name}"]:-}" ]; then continue; fi
    echo "roslab: left out: ${folder}, for ${seen["${name}"]} is a package called ${name}, too"
    touch "${folder}/CATKIN_IGNORE" "${folder}/COLCON_IGNORE"
  done
  for each in "${found[@]}"; do
    name="${each%%$'\t'*}"
    if [ -z "${seen["${name}"]:-}" ]; then seen["${name}"]="${each#*$'\t'}"; fi
  done
done
