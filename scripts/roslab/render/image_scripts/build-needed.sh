#!/bin/bash
# usage: build-needed [--apart FOLDER]... [--keep PACKAGE]... FOLDER COMMAND...
# Runs a command that builds the workspace in the current folder. Where it fails, it is run once more without the packages
# of cloned repositories, and of folders of it that are apart, which the repository in FOLDER does not need: they are
# compiled whole, often for one package. Needed is what its build files, code or launch files name, what is kept, and what
# these need in turn; what lies in a folder with CATKIN_IGNORE or its like needs nothing.
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

apart=() kept=()
while [[ "$1" = --* ]]; do
  if [ "$1" = --apart ]; then apart+=("$2"); else kept+=("$2"); fi
  shift 2
done
own="$1"
shift

if "$@"; then exit 0; fi
if [ ! -d "${own}" ]; then exit 1; fi

# Words may be many: they are handed over by a file
words="$(mktemp)"
without=(--without "${own}") prune=()
for folder in "${apart[@]}"; do
  if [ -d "${own}/${folder}" ]; then without+=(--but "${own}/${folder}"); fi
  prune+=(-path "${own}/${folder}" -o)
done
while read -r path; do prune+=(-path "${path}" -o); done < <(
  find "${own}" -regextype posix-extended -regex '.*/(AMENT|CATKIN|COLCON)_IGNORE' -printf '%h\n'
)
endings='cmake|launch|xml|xacro|urdf|py|yaml|rviz|c|cc|cpp|cxx|h|hh|hpp|msg|srv|action'
find "${own}" \( "${prune[@]}" -name .git \) -prune -o -type f -regextype posix-extended \
  -regex ".*(/CMakeLists[.]txt|[.](${endings}))" -print0 |
  xargs --null --no-run-if-empty grep --no-filename --only-matching --extended-regexp '[A-Za-z][A-Za-z0-9_-]+' |
  sort --unique >"${words}" || true
mapfile -t needed < <(
  xargs --arg-file="${words}" workspace-packages needed src "${without[@]}" "${kept[@]}" | cut --fields=1 | sort --unique
)
rm "${words}"
if [ "${#needed[@]}" -eq 0 ]; then exit 1; fi
mapfile -t left_out < <(workspace-packages hide src "${without[@]}" "${needed[@]}")
if [ "${#left_out[@]}" -eq 0 ]; then exit 1; fi
echo "roslab: the workspace does not build: once more without packages of cloned repositories that nothing here needs"
echo "roslab: left out: ${left_out[*]}"
"$@"
