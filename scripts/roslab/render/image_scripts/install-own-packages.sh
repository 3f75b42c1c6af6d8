#!/bin/bash
# usage: install-own-packages FILE...
# Installs packages that the repository holds, with what they depend on, each by itself. One for another machine or another
# Ubuntu is named and left out; one that fails half-way is removed, as apt would stop at it ever after.
set -euo pipefail

left_out=/usr/local/share/roslab/left-out.txt
install=(apt-get install --yes --no-remove --no-install-recommends)

apt-get update
for file in "$@"; do
  if "${install[@]}" --simulate "${file}" >/dev/null 2>&1 && "${install[@]}" "${file}"; then continue; fi
  name="$(dpkg-deb --field "${file}" Package 2>/dev/null || true)"
  if [ -n "${name}" ] && dpkg --status "${name}" >/dev/null 2>&1; then
    dpkg --purge --force-all "${name}" || true
  fi
  echo "apt ${file##*/}" >>"${left_out}"
  echo "roslab: left out: apt ${file##*/}"
done
rm -rf /var/cache/{apt/*.bin,ldconfig/aux-cache} /var/log/{apt/[!h]*,alternatives.log,dpkg.log}
find /var/log/apt -name history.log -exec sed --in-place '/-Date: /d' {} +
