#!/bin/bash
# usage: workspace-packages needed|hide|show FOLDER [--without PATH [--but PATH]...] NAME...
# Of the packages below a folder, but those below a path that is left out, and not below what is left in it:
#   needed  prints the named ones and what they need in turn, each with its package.xml behind a tab: what their package.xml
#           names, what their launch files and models find, and what makes the plugins that the models load
#   hide    puts the markers by which catkin and colcon pass by into all but the named ones, and prints their names
#   show    takes these markers out of the named ones and of what they need in turn, and prints their names; not where
#           another one of the name is not hidden
# What lies in a folder with another such marker is none of them.
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

what="$1" folder="$2" without='' but=()
shift 2
while [[ "${1:-}" = --* ]]; do
  if [ "$1" = --without ]; then without="$2"; else but+=("$2"); fi
  shift 2
done
# Prints the packages that launch files and models below a folder find or start
found_by() {
  local name='[[:space:]]*["'"'"']?[A-Za-z][A-Za-z0-9_-]*'
  { grep --recursive --no-filename --only-matching --extended-regexp \
    --include='*.launch' --include='*.launch.*' --include='*launch*.py' --include='*.xacro' --include='*.urdf' --include='*.sdf' --include='*.test' \
    "([$][(](find|find-pkg-share|find-pkg-prefix) +|package://|(pkg|package) *=|(FindPackageShare|FindPackagePrefix|get_package_share_directory|get_package_prefix|get_package_share_path)[(])${name}" \
    "$1" || true; } | sed --regexp-extended 's:.*[^A-Za-z0-9_-]::' | sort --unique
}

# Prints the packages whose CMake makes the plugins (libNAME.so) that models below a folder load
makes_plugins_of() {
  local library name
  while read -r library; do
    for name in "${!file_of[@]}"; do
      if grep --quiet --no-messages --extended-regexp "add_library\([[:space:]]*${library}([[:space:])]|$)" "$(dirname "${file_of["${name}"]}")/CMakeLists.txt"; then
        echo "${name}"
      fi
    done
  done < <({ grep --recursive --no-filename --only-matching --extended-regexp \
    --include='*.xacro' --include='*.urdf' --include='*.sdf' --include='*.gazebo' --include='*.world' \
    'lib[A-Za-z0-9_]+[.]so' "$1" || true; } | sed 's/^lib//; s/[.]so$//' | sort --unique)
}

own='hidden by workspace-packages'
hidden() { find "${folder}" -name .git -prune -o -name CATKIN_IGNORE -exec grep --quiet --fixed-strings "${own}" {} \; -printf '%h\n'; }
marked=()
while read -r path; do marked+=(-path "${path}" -o); done < <(
  find "${folder}" -regextype posix-extended -regex '.*/(AMENT|CATKIN|COLCON)_IGNORE' -printf '%h\n'
)
declare -A file_of=() named=()
while read -r manifest; do
  name="$(read-manifest name "${manifest}")"
  if [ -n "${name}" ]; then file_of["${name}"]="${manifest}"; fi
done < <(
  find "${folder}" \( "${marked[@]}" -name .git -o -path "${without}" \) -prune -o -name package.xml -print
  if [ "${#but[@]}" -gt 0 ]; then find "${but[@]}" \( "${marked[@]}" -name .git \) -prune -o -name package.xml -print; fi
)

if [ "${what}" = show ]; then
  declare -A place_of=()
  while read -r here; do
    name="$(read-manifest name "${here}/package.xml")"
    if [ -n "${name}" ]; then place_of["${name}"]="${here}"; fi
  done < <(hidden)
  queue=("$@")
  while [ "${#queue[@]}" -gt 0 ]; do
    more=()
    for name in "${queue[@]}"; do
      here="${place_of["${name}"]:-}"
      if [ -z "${here}" ] || [ -n "${file_of["${name}"]:-}" ]; then continue; fi
      unset "place_of[${name}]"
      rm "${here}/CATKIN_IGNORE" "${here}/COLCON_IGNORE"
      echo "${name}"
      mapfile -t -O "${#more[@]}" more < <(read-manifest depends "${here}/package.xml" && found_by "${here}")
    done
    queue=("${more[@]}")
  done
  exit 0
fi

queue=("$@")
while [ "${#queue[@]}" -gt 0 ]; do
  more=()
  for name in "${queue[@]}"; do
    manifest="${file_of["${name}"]:-}"
    if [ -z "${manifest}" ] || [ -n "${named["${name}"]:-}" ]; then continue; fi
    named["${name}"]=yes
    if [ "${what}" = hide ]; then continue; fi
    printf '%s\t%s\n' "${name}" "${manifest}"
    here="$(dirname "${manifest}")"
    mapfile -t -O "${#more[@]}" more < <(read-manifest depends "${manifest}" && found_by "${here}" && makes_plugins_of "${here}")
  done
  queue=("${more[@]}")
done
if [ "${what}" = needed ]; then exit 0; fi

for name in "${!file_of[@]}"; do
  here="$(dirname "${file_of["${name}"]}")"
  if [ -n "${named["${name}"]:-}" ] || [ -e "${here}/CATKIN_IGNORE" ]; then continue; fi
  for other in "${!named[@]}"; do
    if [[ "$(dirname "${file_of["${other}"]}")/" = "${here}/"* ]]; then continue 2; fi # the marker would hide it
  done
  echo "${own}" | tee "${here}/CATKIN_IGNORE" >"${here}/COLCON_IGNORE"
  echo "${name}"
done | sort
