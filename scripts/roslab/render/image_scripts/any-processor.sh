#!/bin/bash
# usage: any-processor FOLDER
# Lets CMake files below the folder compile for usual PCs since 2013, or for every ARM of 64 bits, where they compile for the
# processor of the machine that builds: on another one the programs may stop with an illegal instruction. What uses
# instructions of that PC, AVX2 and older ones, compiles as before.
set -euo pipefail

case "$(uname --machine)" in
  x86_64) processor=core-avx2 ;;
  aarch64) processor=armv8-a ;;
  *) exit 0 ;;
esac
{ grep --recursive --files-with-matches --null --include=CMakeLists.txt --include='*.cmake' \
  --regexp='-m\(arch\|cpu\)=native' "$1" || true; } |
  xargs --null --no-run-if-empty sed --in-place --regexp-extended "s/-m(arch|cpu)=native\b/-march=${processor}/g"
