#!/bin/bash
# usage: take-message-branches [--before DAY] [--keep NAME]... FOLDER INTERFACE...
# The repository includes the headers of these messages, services and actions (acme_msgs/Grip). Where their package lies in a
# clone in FOLDER that has none of that name, the newest branch of the clone that has all of them is taken. What is taken is
# told, and what no branch has.
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
  local name
  name="$(plain <<<"$1")"
  sed --quiet --regexp-extended 's#^(.*/)?([^/]+)\.(msg|srv|action|idl|h|hpp)$#\2#p; s#^(.*/)?([^/]+)\.cfg$#\2Config#p' | plain |
    grep --line-regexp --extended-regexp "${name}|$(sed --regexp-extended 's/(action)?(request|response|goal|result|feedback|action)$//' <<<"${name}")" >/dev/null # not --quiet: what is before it would end with an error
}
all_made_of() { # PATHS NAME...
  local paths="$1" name
  shift
  for name in "$@"; do
    if ! made_of "${name}" <<<"${paths}"; then return 1; fi
  done
}
for package in $(printf '%s\n' "$@" | cut --delimiter=/ --fields=1 | sort --unique); do
  manifest="$(find "${folder}" -name .git -prune -o -name package.xml -exec grep --files-with-matches --extended-regexp "<name>\s*${package}\s*</name>" {} + | head --lines=1 || true)"
  if [ -z "${manifest}" ]; then continue; fi
  there="$(dirname "${manifest}")"
  paths="$(find "${there}" -name .git -prune -o -type f -print)"
  lacking=()
  for interface in "$@"; do
    if [ "${interface%%/*}" = "${package}" ] && ! made_of "${interface#*/}" <<<"${paths}"; then lacking+=("${interface#*/}"); fi
  done
  if [ "${#lacking[@]}" -eq 0 ] || ! clone="$(git -C "${there}" rev-parse --show-toplevel 2>/dev/null)"; then continue; fi
  name="$(basename "${clone}")" taken='' branches=()
  if [[ " ${keep[*]} " != *" ${name} "* ]]; then
    mapfile -t branches < <(git -C "${clone}" for-each-ref --sort=-committerdate --format='%(refname:strip=3)' refs/remotes/origin | grep --invert-match --line-regexp HEAD | head --lines=60)
  fi
  for branch in "${branches[@]}"; do
    at="origin/${branch}"
    if [ -n "${day}" ]; then at="$(git -C "${clone}" rev-list --max-count=1 --first-parent --before="${day}T23:59:59Z" "${at}")"; fi
    if [ -n "${at}" ] && all_made_of "$(git -C "${clone}" ls-tree -r --name-only "${at}")" "${lacking[@]}"; then
      git -C "${clone}" -c advice.detachedHead=false checkout --quiet "${at}" -- || continue
      taken="${branch}"
      break
    fi
  done
  said="the code includes ${lacking[*]} of ${package}, which ${name} does not have"
  if [ -n "${taken}" ]; then echo "roslab: ${said}: its branch ${taken} is taken"; else echo "roslab: ${said}: what includes that cannot be built"; fi
done
