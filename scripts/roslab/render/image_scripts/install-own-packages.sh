#!/bin/bash
# usage: install-own-packages FILE|URL...
# Installs packages that the repository holds or that are fetched, with what they depend on, each by itself. One for another
# machine or another Ubuntu, or that does not answer, is named and left out, and what is installed of its name stays; one
# that fails half-way is removed if it is new, as apt would stop at it ever after.
set -euo pipefail

left_out=/usr/local/share/roslab/left-out.txt
install=(apt-get install --yes --no-remove --no-install-recommends)

apt-get update
folder="$(mktemp --directory)"
chmod 755 "${folder}"
for file in "$@"; do
  if [[ ${file} == *://* ]]; then
    command -v curl >/dev/null || apt-get install --yes --no-install-recommends ca-certificates curl
    curl --fail --location --silent --show-error --retry 3 --connect-timeout 30 --max-filesize 1000000000 \
      --output "${folder}/${file##*/}" "${file}" || echo "roslab: ${file} cannot be fetched"
    file="${folder}/${file##*/}"
  fi
  name="$(dpkg-deb --field "${file}" Package 2>/dev/null || true)"
  before="$(dpkg --status "${name}" 2>/dev/null || true)"
  if "${install[@]}" --simulate "${file}" >/dev/null 2>&1; then
    if "${install[@]}" "${file}"; then continue; fi
    if [ -n "${name}" ] && [ -z "${before}" ]; then dpkg --purge --force-all "${name}" || true; fi
  fi
  echo "apt ${file##*/}" >>"${left_out}"
  echo "roslab: left out: apt ${file##*/}"
done
rm -rf "${folder}"
rm -rf /var/cache/{apt/*.bin,ldconfig/aux-cache} /var/log/{apt/[!h]*,alternatives.log,dpkg.log}
find /var/log/apt -name history.log -exec sed --in-place '/-Date: /d' {} +
