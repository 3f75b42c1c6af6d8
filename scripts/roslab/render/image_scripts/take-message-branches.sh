#!/bin/bash
# usage: take-message-branches [--before DAY] [--keep NAME]... FOLDER INTERFACE...
# The repository includes the headers of these messages, services and actions (acme_msgs/Grip), or these headers (acme/grip.hpp).
# Where their package lies in a clone in FOLDER that has none of that name, the newest branch of the clone that has all of
# them is taken. What is taken is told, and the messages that no branch has; a header that none has may be generated.
#   --before DAY  the newest commit not after this day (YYYY-MM-DD)
#   --keep NAME   a clone that stays as it is, for its tag or commit is given
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

day='' keep=()
while [[ "$1" = --* ]]; do
  case "$1" in
    --before) day="$2" ;;
    --keep) keep+=("$2") ;;
  esac
  shift 2
done
folder="$1"
shift
plain() { tr --delete '_-' | tr '[:upper:]' '[:lower:]'; }
# Tells whether one of the paths from standard input is the file that a header is generated from, or is that header
made_of() { # NAME
  local name="$1" endings='h|hpp|'
  if [[ "${name}" = *.* ]]; then
    name="${name%.*}" endings=''
  fi
  name="$(plain <<<"${name}")"
  sed --quiet --regexp-extended "s#^(.*/)?([^/]+)\\.(${endings}msg|srv|action|idl)\$#\\2#p; s#^(.*/)?([^/]+)\\.cfg\$#\\2Config#p" | plain |
    grep --line-regexp --extended-regexp "${name}|$(sed --regexp-extended 's/(action)?(request|response|goal|result|feedback|action)$//' <<<"${name}")" >/dev/null # not --quiet: what is before it would end with an error
}
all_made_of() { # PATHS NAME...
  local paths="$1" name
  shift
  for name in "$@"; do
    if [[ "${name}" = *.* ]] && sed 's#.*/##; s#\.in$##' <<<"${paths}" | grep --line-regexp --fixed-strings "${name}" >/dev/null; then continue; fi
    if ! made_of "${name}" <<<"${paths}"; then return 1; fi
  done
}
# Tells whether the package is of the same ROS in a commit; one that lies elsewhere there may be
of_this_ros() { # COMMIT
  local now=1 before=1 text
  text="$(git -C "${clone}" show "$1:${manifest#"${clone}/"}" 2>/dev/null)" || return 0
  if grep --quiet catkin "${manifest}"; then now=0; fi
  if grep --quiet catkin <<<"${text}"; then before=0; fi
  [ "${now}" -eq "${before}" ]
}
first_with() { # NAME...
  local each
  for each in "${commits[@]}"; do
    if all_made_of "$(git -C "${clone}" ls-tree -r --name-only "${each%% *}")" "$@"; then
      echo "${each}"
      return
    fi
  done
}
for package in $(printf '%s\n' "$@" | cut --delimiter=/ --fields=1 | sort --unique); do
  manifest="$(find "${folder}" -name .git -prune -o -name package.xml -exec grep --files-with-matches --extended-regexp "<name>\s*${package}\s*</name>" {} + | head --lines=1 || true)"
  if [ -z "${manifest}" ]; then continue; fi
  there="$(dirname "${manifest}")"
  if ! clone="$(git -C "${there}" rev-parse --show-toplevel 2>/dev/null)"; then continue; fi
  paths="$(find "${there}" -name .git -prune -o -type f -print)"
  lacking=() named=()
  for interface in "$@"; do
    if [ "${interface%%/*}" != "${package}" ]; then continue; fi
    named+=("${interface#*/}")
    if ! all_made_of "${paths}" "${interface#*/}"; then lacking+=("${interface#*/}"); fi
  done
  if [ "${#lacking[@]}" -eq 0 ]; then continue; fi
  name="$(basename "${clone}")" taken='' branches=() commits=()
  if [[ " ${keep[*]} " != *" ${name} "* ]]; then
    mapfile -t branches < <(git -C "${clone}" for-each-ref --sort=-committerdate --format='%(refname:strip=3)' refs/remotes/origin | grep --invert-match --line-regexp HEAD | head --lines=60)
  fi
  for branch in "${branches[@]}"; do
    at="origin/${branch}"
    if [ -n "${day}" ]; then at="$(git -C "${clone}" rev-list --max-count=1 --first-parent --before="${day}T23:59:59Z" "${at}")"; fi
    if [ -n "${at}" ] && of_this_ros "${at}"; then commits+=("${at} ${branch}"); fi
  done
  real=()
  for interface in "${lacking[@]}"; do
    if [[ "${interface}" != *.* ]] || [ -n "$(first_with "${interface}")" ]; then real+=("${interface}"); fi
  done
  if [ "${#real[@]}" -eq 0 ]; then continue; fi
  taken="$(first_with "${named[@]}")"
  if [ -z "${taken}" ]; then taken="$(first_with "${real[@]}")"; fi
  said="the code includes ${real[*]} of ${package}, which ${name} does not have"
  if [ -n "${taken}" ] && git -C "${clone}" -c advice.detachedHead=false checkout --quiet "${taken%% *}" --; then
    echo "roslab: ${said}: its branch ${taken#* } is taken"
  else
    echo "roslab: ${said}: what includes that cannot be built"
  fi
done
