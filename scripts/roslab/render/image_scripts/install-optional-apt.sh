#!/bin/bash
# usage: install-optional-apt PACKAGE...
# Installs the packages that apt knows, together where that works, else one by one. The others are named and left out.
set -euo pipefail

left_out=/usr/local/share/roslab/left-out.txt
install=(apt-get install --yes --no-remove --no-install-recommends)
known=()

apt-get update
for package in "$@"; do
  if "${install[@]}" --simulate "${package}" >/dev/null 2>&1; then
    known+=("${package}")
  else
    echo "apt ${package}" >>"${left_out}"
  fi
done
if [ "${#known[@]}" -gt 0 ] && ! "${install[@]}" "${known[@]}"; then
  for package in "${known[@]}"; do
    "${install[@]}" "${package}" || echo "apt ${package}" >>"${left_out}"
  done
fi
if [ -s "${left_out}" ]; then sed 's/^/roslab: left out: /' "${left_out}"; fi
rm -rf /var/cache/{apt/*.bin,ldconfig/aux-cache} /var/log/{apt/[!h]*,alternatives.log,dpkg.log}
find /var/log/apt -name history.log -exec sed --in-place '/-Date: /d' {} +
