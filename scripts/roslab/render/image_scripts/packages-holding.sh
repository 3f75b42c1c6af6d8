#!/bin/bash
# usage: packages-holding [LIST]
# Without LIST, fetches the index of the files that the packages of the package sources hold.
# Prints for each line of LIST, a regular expression that the path of a file matches as a whole, its number and each package of
# the package sources that holds such a file. Fails where they have no index of files.
set -euo pipefail

if [ $# -eq 0 ]; then
  apt-get update
  apt-get install --yes --no-install-recommends apt-file
  apt-file update
  exit
fi
number=0
while read -r path; do
  number=$((number + 1))
  { apt-file search --regexp "^/${path}\$" </dev/null || [ $? = 1 ]; } | sed --quiet "s/: .*//; s/^[a-z0-9]/${number} &/p" | sort --unique
done <"$1"
