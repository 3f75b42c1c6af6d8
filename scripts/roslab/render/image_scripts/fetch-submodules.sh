#!/bin/bash
# usage: fetch-submodules FOLDER
# Fetches the submodules of a clone, and theirs in turn. Where one of them is private or gone git checks out none of them
# all: then each is fetched by itself, and those that cannot be had are named and left out.
set -euo pipefail

share=/usr/local/share/roslab
export GIT_TERMINAL_PROMPT=0 # a host without such a repository asks for a password, which nobody is there to give
fetch() {
  local path
  if [ ! -e "$1/.gitmodules" ] || git -C "$1" submodule update --init --recursive; then return; fi
  while read -r -d '' path; do
    if git -C "$1" submodule update --init --force -- "${path}"; then # it may be cloned, and not checked out yet
      fetch "$1/${path}"
    else
      echo "roslab: left out: ${1##*/}/${path} cannot be cloned"
      if [ -w "${share}" ]; then echo "source ${1##*/}/${path}" >>"${share}/left-out.txt"; fi
    fi
  done < <(git -C "$1" ls-files --stage -z | sed --null-data --quiet 's/^160000 [^\t]*\t//p')
}
fetch "${1%/}"
