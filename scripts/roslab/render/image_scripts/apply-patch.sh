#!/bin/bash
# usage: apply-patch [--stops] FOLDER PATCH COMMAND...
# Applies a patch of the repository to a clone, by the command of its author. Where it does not fit, that is told; a clone
# that has what the patch changes already, or that could not be cloned, stops nothing.
#   --stops   the author's build stops where the patch does not fit, and so does this one
set -eo pipefail

stops=''
if [ "$1" = --stops ]; then
  stops=yes
  shift
fi
folder="$1" patch="$2" name="${2##*/}"
shift 2
if [ ! -d "${folder}" ]; then
  echo "roslab: left out: ${name}, as ${folder} is not there"
  exit 0
fi
cd "${folder}"

run() { # OPTION...
  if [ "${command[0]}" = git ]; then "${command[@]}" "$@" "${patch}"; else "${command[@]}" "$@" --force --input "${patch}"; fi
}
# Of several commits in one file, patch's own --dry-run tries each on the files as they are: it is tried on a copy
fits() { # OPTION...
  if [ "${command[0]}" = git ]; then
    run --check "$@"
    return
  fi
  local copy answer=0
  copy="$(mktemp --directory)"
  cp --archive . "${copy}"
  (cd "${copy}" && run "$@") || answer=$?
  rm -rf "${copy}"
  return "${answer}"
}
# With --3way git takes a patch for applied that is there already: whether it is, the same call without that tells
plain=()
for word in "$@"; do case ${word} in -3 | --3way) ;; *) plain+=("${word}") ;; esac done
command=("${plain[@]}")
if ! fits >/dev/null 2>&1 && fits --reverse >/dev/null 2>&1; then
  echo "roslab: ${folder##*/} has what ${name} changes already"
  exit 0
fi
command=("$@")
if fits; then
  run
  echo "roslab: ${name} is applied to ${folder##*/}"
elif [ -n "${stops}" ]; then
  echo "roslab: ${name} does not fit ${folder##*/}: the build stops there, as its author's does" >&2
  exit 1
else
  echo "roslab: left out: ${name}, which does not fit ${folder##*/}"
fi
