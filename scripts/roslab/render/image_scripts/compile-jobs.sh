#!/bin/bash
# usage: compile-jobs [MOST]
# Prints how many compilers may run at once: as many as there are cores, each with 2 GB of memory to itself, at most MOST.
set -euo pipefail

cores="$(nproc)" most="${1:-$(nproc)}"
awk -v cores="$((most < cores ? most : cores))" '/^MemAvailable/ {n = int($2 / 2000000); print (n < 1) ? 1 : (n > cores) ? cores : n}' \
  /proc/meminfo
