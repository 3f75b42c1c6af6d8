#!/bin/bash
# usage: eval "$(git-as-of DAY)"
# Comes before git itself in PATH for the rest of this step, under its name. It is git, but brings each clone to the last
# commit of a day (UTC): pip and CMake fetch repositories and know no days.
# A commit or another branch that they are told to take is checked out afterwards, as ever.
set -euo pipefail

# The name alone is there: nothing can be executed in this folder, which no layer keeps
before=/dev/shm/as-of
if [[ "${1:-}" = [0-9]* ]]; then # as no command of git begins
  mkdir -p "${before}"
  ln -sf "$(command -v git-as-of)" "${before}/git"
  echo "export GIT_AS_OF=$1 PATH=\"${before}:\${PATH}\""
  exit 0
fi

PATH="${PATH//"${before}:"/}"
if [[ " $* " != *" clone "* ]]; then
  exec git "$@"
fi
git "$@"
folder="${!#}"
if [ ! -e "${folder}/.git" ]; then  # git names it by the address
  folder="${folder%/}"
  folder="${folder##*[/:]}"
  folder="${folder%.git}"
fi
if [ ! -e "${folder}/.git" ]; then exit 0; fi
commit="$(git -C "${folder}" rev-list -1 --first-parent --before="${GIT_AS_OF}T23:59:59Z" HEAD)"
if [ -n "${commit}" ]; then
  git -C "${folder}" reset --quiet --hard "${commit}"
else
  echo "roslab: ${folder##*/} has no commit of ${GIT_AS_OF} or before: its newest one is taken" >&2
fi
