#!/bin/bash
# usage: install-by-make JOBS
# Compiles and installs a library by the Makefile in the current folder, and copies all that it put below /usr and /opt
# to /installed: a Makefile that somebody wrote by hand may not know DESTDIR.
set -euo pipefail

before="$(mktemp)"
make --jobs="$1"
make install
mkdir --parents /installed
find /usr /opt -cnewer "${before}" '(' -type f -o -type l ')' -print0 |
  tar --create --null --no-recursion --files-from=- | tar --extract --directory=/installed
rm "${before}"
