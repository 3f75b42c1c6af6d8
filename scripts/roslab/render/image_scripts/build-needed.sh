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
if [ ! -d "${own}" ]; then exit 1; fi

# Words may be many: they are handed over by a file
words="$(mktemp)"
grep --recursive --no-filename --only-matching --extended-regexp '[A-Za-z][A-Za-z0-9_-]+' "${own}" \
  --include={package.xml,CMakeLists.txt,'*.'{cmake,launch,xml,xacro,urdf,py,yaml,rviz,c,cc,cpp,cxx,h,hh,hpp,msg,srv,action}} |
  sort --unique >"${words}" || true
mapfile -t needed < <(
  xargs --arg-file="${words}" workspace-packages needed src --without "${own}" "${kept[@]}" | cut --fields=1 | sort --unique
)
rm "${words}"
if [ "${#needed[@]}" -eq 0 ]; then exit 1; fi
mapfile -t left_out < <(workspace-packages hide src --without "${own}" "${needed[@]}")
if [ "${#left_out[@]}" -eq 0 ]; then exit 1; fi
echo "roslab: the workspace does not build: once more without packages of cloned repositories that nothing here needs"
echo "roslab: left out: ${left_out[*]}"
"$@"
