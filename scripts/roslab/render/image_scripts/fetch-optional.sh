#!/bin/bash
# usage: fetch-optional URL PATH [FOLDER [STRIP]]
# Fetches a file of at most 1 GB to a path of this folder, and unpacks it to FOLDER, without the first
# STRIP folders of its paths. What does not answer, is larger, or
# is a page in place of a file, is named and left out.
set -euo pipefail

most=1000000000
url="$1" path="$2"
leave_out() {
  echo "roslab: left out: ${url}: $1"
  rm -f "${path}"
  exit 0
}

mkdir --parents "$(dirname "${path}")"
echo "roslab: fetching ${url}"
curl --fail --location --silent --show-error --retry 3 --connect-timeout 30 --max-filesize "${most}" --remote-time \
  --output "${path}" "${url}" || leave_out "it cannot be fetched, or has more than 1 GB"
if [ "$(stat --format %s "${path}")" -gt "${most}" ]; then leave_out "it has more than 1 GB"; fi
case "${path}" in
  *.html | *.htm | *.xml | *.svg) ;;
  *) if head --bytes 512 "${path}" | grep --quiet --ignore-case '<!doctype html\|<html'; then
    leave_out "it is a page, not a file"
  fi ;;
esac
if [ $# -gt 2 ]; then
  mkdir --parents "$3"
  case "${path}" in
    *.zip) unzip -q -o "${path}" -d "$3" || leave_out "it cannot be unpacked" ;;
    *) tar --extract --no-same-owner --strip-components "${4:-0}" --file "${path}" --directory "$3" || leave_out "it cannot be unpacked" ;;
  esac
  rm "${path}"
fi
