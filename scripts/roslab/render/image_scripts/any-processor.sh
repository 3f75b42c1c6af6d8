#!/bin/bash
# usage: any-processor FOLDER [OPTION...]
# Lets CMake files and Makefiles below the folder compile for usual PCs since 2013, or for every ARM of 64 bits, where they compile for the
# processor of the machine that builds: on another one the programs may stop with an illegal instruction. What uses
# instructions of that PC, AVX2 and older ones, compiles as before.
# The options, which the compiler for ARM does not know, are replaced there by one without effect; where CMake only asks
# whether the compiler takes one, it stays.
set -euo pipefail

folder=$1
shift
case "$(uname --machine)" in
  x86_64) processor=core-avx2 ;;
  aarch64) processor=armv8-a ;;
  *) exit 0 ;;
esac
edit=(--expression "s/-m(arch|cpu)=native\b/-march=${processor}/g")
if [ "$processor" = armv8-a ]; then
  for option; do
    word="(^|[^[:alnum:]_.=-])${option//[.+]/\\&}($|[^[:alnum:]_.=-])"
    once="/(if|check_[a-z_]*)[[:space:]]*\(/I!s/${word}/\1-pipe\2/g"
    edit+=(--expression "$once" --expression "$once") # twice, for two that one blank parts
  done
fi
{ grep --recursive --files-with-matches --null --include=CMakeLists.txt --include='*.cmake' \
  --include=Makefile --include=makefile --include=GNUmakefile --include='*.mk' \
  --regexp='-m\(arch\|cpu\)=native' "${@/#/--regexp=}" "$folder" || true; } |
  xargs --null --no-run-if-empty sed --in-place --regexp-extended "${edit[@]}"
