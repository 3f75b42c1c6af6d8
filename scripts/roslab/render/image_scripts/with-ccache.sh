#!/bin/bash
# usage: with-ccache COMPILER ARGUMENT... | with-ccache --told COMMAND...
# Compiles a file, or takes what an earlier build made of the very same, where a cache is mounted and the image has ccache. CMake
# calls it (CMAKE_CXX_COMPILER_LAUNCHER). With --told it runs a command that compiles many, and tells how many were taken.
# ccache would preprocess each file before it is compiled; with CCACHE_DEPEND it reads what the compiler itself tells of
# headers (-MD), which files of CMake before 3.20 do not ask for. https://ccache.dev/manual/latest.html#_the_depend_mode
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

cache=/var/cache/roslab-build
export CCACHE_DIR="${cache}/ccache" CCACHE_MAXSIZE=500M CCACHE_COMPRESS=1 CCACHE_DEPEND=1
if [ ! -w "${cache}" ] || ! command -v ccache >/dev/null; then
  if [ "$1" = --told ]; then shift; fi
  exec "$@"
fi
if [ "$1" = --told ]; then
  shift
  # Older releases print no counts that a program can read
  taken() { ccache --print-stats 2>/dev/null | awk '/_cache_hit/ { count += $2 } END { print count + 0 }' || true; }
  before="$(taken)"
  "$@"
  if [ "$(taken)" -gt "${before}" ]; then echo "roslab: $(($(taken) - before)) files were compiled by an earlier build"; fi
  exit
fi
compiles='' told='' object='' before=''
for word in "$@"; do
  case "${word}" in
    -c) compiles=yes ;;
    -MMD | -MM) # the compiler does not tell of the system's headers then, which another build may have in another release
      told=yes
      unset CCACHE_DEPEND
      ;;
    -M*) told=yes ;;
  esac
  if [ "${before}" = -o ]; then object="${word}"; fi
  before="${word}"
done
if [ -z "${compiles}" ] || [ -n "${told}" ] || [ -z "${object}" ]; then exec ccache "$@"; fi
ccache "$@" -MD -MF "${object}.d"
rm -f "${object}.d" # CMake has a list of its own
