#!/bin/bash
# Prints how many compilers may run at once: as many as there are cores, each with 2 GB of memory to itself.
set -euo pipefail

awk -v cores="$(nproc)" '/^MemAvailable/ {n = int($2 / 2000000); print (n < 1) ? 1 : (n > cores) ? cores : n}' \
  /proc/meminfo
