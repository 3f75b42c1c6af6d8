#!/bin/bash
# usage: take-snapshots DAY [PATTERN ADDRESS]...
# Makes the base's packages those of a day, and takes all later ones as of that day: each source whose address fits a
# pattern becomes its snapshot. A snapshot that is not there is named, and the sources stay as they were.
set -euo pipefail

here=/usr/local/share/roslab
log=/tmp/apt-update
day="$1" && shift
shopt -s nullglob
mkdir --parents "${here}" /tmp/own-sources

case "$*" in
  *' https://'*)
    if [ ! -e /etc/ssl/certs/ca-certificates.crt ]; then
      apt-get update
      apt-get install --yes --no-install-recommends ca-certificates
    fi
    ;;
esac
cp --recursive /etc/apt/sources.list* /tmp/own-sources
hosts=(snapshots.ros.org)
while [ $# -gt 1 ]; do
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
    if [ -e "${file}" ]; then sed --in-place --regexp-extended "s#$1#$2#" "${file}"; fi
  done
  host="${2#*://}"
  hosts+=("${host%%/*}")
  shift 2
done
# Older packages than those of the base are installed only by such a priority
printf 'Package: *\nPin: origin %s\nPin-Priority: 1001\n\n' "${hosts[@]}" >/etc/apt/preferences.d/roslab-day
cat >/etc/apt/apt.conf.d/99roslab-day <<'CONF'
Acquire::Check-Valid-Until "false";
Dir::Cache::pkgcache "";
Dir::Cache::srcpkgcache "";
Dir::Log::Terminal "/dev/null";
Dir::Log::History "/dev/null";
DPkg::Post-Invoke { "rm -f /var/cache/ldconfig/aux-cache"; };
CONF
# The same packages give the same image: no file of it tells when it was built
rm -f /var/log/apt/* /var/cache/apt/*.bin /var/cache/ldconfig/aux-cache
ln --symbolic --force /dev/null /var/log/dpkg.log
ln --symbolic --force /dev/null /var/log/alternatives.log

LC_ALL=C apt-get update >"${log}" 2>&1 || true
cat "${log}"
if grep --quiet --extended-regexp '^ +(404|410) |^[EW]: Failed to fetch .* (404|410) ' "${log}"; then
  echo "snapshot ${day}" | tee --append "${here}/left-out.txt"
  find /etc/apt/sources.list.d -mindepth 1 -delete
  cp --recursive /tmp/own-sources/. /etc/apt/
  apt-get update
elif grep --quiet --extended-regexp '^Err|^E: |^W: Failed to fetch' "${log}"; then
  echo "roslab: the snapshots of ${day} cannot be reached"
  exit 1
fi
apt-get --yes --no-install-recommends -o APT::Get::allow-downgrades=true dist-upgrade
rm -rf "${log}" /tmp/own-sources
