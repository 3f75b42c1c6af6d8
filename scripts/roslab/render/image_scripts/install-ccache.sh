#!/bin/bash
# usage: install-ccache
# Installs ccache by the lists that a step before has fetched, or by new ones where these are old. It is for the stage that
# compiles alone, and where apt has none, all is compiled by each build.
set -euo pipefail

install=(apt-get install --yes --no-install-recommends ccache)
# What install-rosdep-keys made of the same lists
cache=/var/lib/apt/lists/roslab-cache.bin
if [ -e "${cache}" ]; then install+=(--option "Dir::Cache::srcpkgcache=${cache}"); fi
"${install[@]}" || { apt-get update && "${install[@]}"; } || echo 'roslab: left out: ccache, which would make later builds quicker'
