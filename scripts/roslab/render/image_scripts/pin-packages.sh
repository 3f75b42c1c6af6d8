#!/bin/bash
# usage: pin-packages NAME
# Has apt take the versions of roslab.lock that the list NAME has for this machine: a package, its version and, where
# the version is one machine's alone, dpkg's name of that machine on each line.
set -euo pipefail

awk -v own="$(dpkg --print-architecture)" '
  $3 == "" || $3 == own { printf "Package: %s\nPin: version %s\nPin-Priority: 1001\n\n", $1, $2 }
' "/usr/local/share/roslab/lock/$1" >/etc/apt/preferences.d/roslab-lock
