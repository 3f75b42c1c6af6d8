#!/bin/bash
# Removes NVIDIA's package source where the base has only its old key: NVIDIA changed it in 2022.
# CUDA itself is in the base already.
set -euo pipefail

apt-get update >/tmp/update 2>&1 || true
if grep --quiet 'NO_PUBKEY A4B469963BF863CC' /tmp/update; then
  { grep -lr developer.download.nvidia.com /etc/apt/sources.list.d || true; } | xargs --no-run-if-empty rm
  echo "source developer.download.nvidia.com" | tee --append /usr/local/share/roslab/left-out.txt
fi
rm -rf /tmp/update /var/lib/apt/lists/*
