#!/bin/bash
# usage: build-needed [--apart FOLDER]... [--keep PACKAGE]... [--tried FOLDER]... FOLDER COMMAND...
# Runs a command that builds the workspace in the current folder. Where it fails, it is run once more without the packages
# of cloned repositories, and of folders of it that are apart, which the repository in FOLDER does not need: they are
# compiled whole, often for one package. Needed is what its build files, code or launch files name, what is kept, and what
# these need in turn; what lies in a folder with CATKIN_IGNORE or its like needs nothing. Where that fails, too, it is run
# without those packages of repositories that were only tried which nothing is compiled with.
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

apart=() kept=() tried=()
while [[ "$1" = --* ]]; do
  case "$1" in
    --apart) apart+=("$2") ;;
    --keep) kept+=("$2") ;;
    --tried) if [ -d "src/$2" ]; then tried+=("src/$2"); fi ;;
  esac
  shift 2
done
own="$1"
shift

if "$@"; then exit 0; fi
if [ ! -d "${own}" ]; then exit 1; fi

# Prints the words of the files with these endings below folders, but those that `prune` tells to pass by
words() {
  local endings="$1"
  shift
  find "$@" \( "${prune[@]}" -name .git \) -prune -o -type f -regextype posix-extended \
    -regex ".*(/CMakeLists[.]txt|[.](${endings}))" -print0 |
    xargs --null --no-run-if-empty grep --no-filename --only-matching --extended-regexp '[A-Za-z][A-Za-z0-9_-]+' |
    sort --unique || true
}
pass_by_marked() {
  while read -r path; do prune+=(-path "${path}" -o); done < <(
    find "$1" -regextype posix-extended -regex '.*/(AMENT|CATKIN|COLCON)_IGNORE' -printf '%h\n'
  )
}
# What the words of the input name, and what that needs in turn; words may be many: they are handed over by a file
named() {
  local file
  file="$(mktemp)"
  cat >"${file}"
  xargs --arg-file="${file}" workspace-packages needed "$@" | cut --fields=1 | sort --unique
  rm "${file}"
}

compiled='cmake|c|cc|cpp|cxx|h|hh|hpp|msg|srv|action'
without=(--without "${own}") prune=()
for folder in "${apart[@]}"; do
  if [ -d "${own}/${folder}" ]; then without+=(--but "${own}/${folder}"); fi
  prune+=(-path "${own}/${folder}" -o)
done
pass_by_marked "${own}"
mapfile -t needed < <(words "${compiled}|launch|xml|xacro|urdf|py|yaml|rviz" "${own}" | named src "${without[@]}" "${kept[@]}")
left_out=()
if [ "${#needed[@]}" -gt 0 ]; then mapfile -t left_out < <(workspace-packages hide src "${without[@]}" "${needed[@]}"); fi
if [ "${#left_out[@]}" -gt 0 ]; then
  echo "roslab: the workspace does not build: once more without packages of cloned repositories that nothing here needs"
  echo "roslab: left out: ${left_out[*]}"
  if [ "${#tried[@]}" -eq 0 ]; then exec "$@"; fi
  if "$@"; then exit 0; fi
fi

if [ "${#tried[@]}" -eq 0 ]; then exit 1; fi
prune=()
pass_by_marked src
for folder in "${tried[@]}"; do prune+=(-path "${folder}" -o); done
mapfile -t needed < <(words "${compiled}" src | named src "${without[@]}")
left_out=()
for folder in "${tried[@]}"; do
  mapfile -t -O "${#left_out[@]}" left_out < <(workspace-packages hide "${folder}" "${needed[@]}")
done
if [ "${#left_out[@]}" -eq 0 ]; then exit 1; fi
echo "roslab: the workspace does not build: once more without what was only tried and what nothing is compiled with"
echo "roslab: left out: ${left_out[*]}"
"$@"
