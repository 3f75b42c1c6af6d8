#!/bin/bash
# usage: plain-apart COMMAND...
# Compiles the workspace in the current folder by a command that calls catkin_make. Where what is cloned to it brings a package
# of plain CMake, catkin_make refuses the workspace: catkin_make_isolated compiles each package by itself then, and build and
# devel are links to its folders, so that what names them finds the same. It knows no list of packages that are left out
# (-DCATKIN_BLACKLIST_PACKAGES): these are hidden from it by markers.
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

if [ ! -e devel_isolated ]; then
  said="$(mktemp)"
  if "$@" 2>&1 | tee "${said}"; then
    rm "${said}"
    exit 0
  fi
  refused='This workspace contains non-catkin packages in it'
  if ! grep --quiet --fixed-strings "${refused}" "${said}"; then
    rm "${said}"
    exit 1
  fi
  rm "${said}"
  echo 'roslab: a package of plain CMake is in the workspace, which catkin_make refuses: each package by itself'
  rm -rf build devel
fi
words=() options=()
for word in "$@"; do
  case "${word}" in
    -DCATKIN_BLACKLIST_PACKAGES*=*)
      IFS=';' read -r -a without <<<"${word#*=}"
      for name in "${without[@]}"; do
        workspace-packages needed src "${name}" | sed --quiet "s:^${name}\t\(.*\)/package[.]xml$:\1/CATKIN_IGNORE:p" |
          xargs --delimiter='\n' --no-run-if-empty touch
      done
      ;;
    -D*) options+=("${word}") ;;
    --only-pkg-with-deps*) words+=(--merge "${word}") ;; # it takes that with one folder for all alone
    catkin_make) words+=(catkin_make_isolated) ;;
    *) words+=("${word}") ;;
  esac
done
if [ "${#options[@]}" -gt 0 ]; then words+=(--cmake-args "${options[@]}"); fi
"${words[@]}"
ln --symbolic --force --no-dereference build_isolated build
ln --symbolic --force --no-dereference devel_isolated devel
