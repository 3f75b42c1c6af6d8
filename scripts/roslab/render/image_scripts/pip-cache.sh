#!/bin/bash
# usage: pip-cache
# Prints the option of pip for what it downloads: kept in the cache that is mounted, where its disk has room for that too.
# What was built from source is not kept: it may fit only to the packages that were there.
set -euo pipefail

cache=/root/.cache/pip
room_gb=20 # less is for the image alone, as on a small runner

rm -rf "${cache}/wheels"
free_gb="$(df --output=avail --block-size=1G "${cache}" 2>/dev/null | tail -n 1)" || true
if [ "${free_gb:-0}" -ge "${room_gb}" ]; then
  echo "--cache-dir=${cache}"
else
  echo --no-cache-dir
fi
