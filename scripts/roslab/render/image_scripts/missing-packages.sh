#!/bin/bash
# usage: missing-packages LIST
# Prints each package of LIST that no package source has at its version: its name, that version, and the nearest that is
# left, an older one only where there is no newer. A line of LIST is as in pin-packages.
set -euo pipefail

own="$(dpkg --print-architecture)"
left=/tmp/left
apt-get update >&2
cut --delimiter=' ' --fields=1 "$1" | xargs apt-cache madison 2>/dev/null |
  awk -F' *[|] *' '{ sub(/^ +/, "", $1); print $1, $2 }' | sort --unique >"${left}"

nearest() {
  local found='' version
  while read -r version; do
    if [ -z "${found}" ]; then
      found="${version}"
    elif dpkg --compare-versions "${version}" gt "$2"; then
      if dpkg --compare-versions "${found}" lt "$2" || dpkg --compare-versions "${version}" lt "${found}"; then
        found="${version}"
      fi
    elif dpkg --compare-versions "${found}" lt "${version}"; then
      found="${version}"
    fi
  done < <(awk -v name="$1" '$1 == name { print $2 }' "${left}")
  echo "${found}"
}

while read -r name version machine; do
  if [ -n "${machine}" ] && [ "${machine}" != "${own}" ]; then continue; fi
  if ! grep --quiet --line-regexp --fixed-strings "${name} ${version}" "${left}"; then
    echo "${name} ${version} $(nearest "${name}" "${version}")"
  fi
done <"$1"
