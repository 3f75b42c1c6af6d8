#!/bin/sh
# Prints where this image's packages still come from, fields parted by tabs. Runs in the image, as root, with the network.
#   origin NAME ARCHITECTURE VERSION URL SUITE    apt's source that serves the installed version
#   report ENVIRONMENT JSON                       pip's own report of what it would install: names, versions, hashes
#   file ENVIRONMENT NAME SHA256                  the same of a pip that writes no reports
# usage: online.sh [ENVIRONMENT PYTHON OPTIONS REQUIREMENTS]...    each a word; the last two parted by line breaks
set -u
log=/tmp/roslab-log

if command -v apt-get >/dev/null 2>&1 && apt-get update >"${log}" 2>&1; then
  # shellcheck disable=SC2016 # dpkg's own variables
  dpkg-query --show --showformat '${Package}:${Architecture}\n' | sed 's/:all$//' >/tmp/roslab-names
  xargs apt-cache policy </tmp/roslab-names 2>/dev/null | awk '
    /^[^ ]/ { name = $1; sub(/:$/, "", name); sub(/:[a-z0-9]+$/, "", name); version = ""; next }
    /^ \*\*\* / { version = $2; next }
    /^     [^ ]/ { version = "" }
    version && $2 != "/var/lib/dpkg/status" { print "origin\t" name "\t" $4 "\t" version "\t" $2 "\t" $3; version = "" }
  '
fi

while [ $# -ge 4 ]; do
  environment="$1" python="$2"
  printf '%s\n' "$4" >/tmp/roslab-requirements
  # shellcheck disable=SC2086 # options of pip, which hold no blanks
  set -- "$3" "$@"
  options="$(printf '%s' "$1" | tr '\n' ' ')"
  shift 5
  export PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_BREAK_SYSTEM_PACKAGES=1 PIP_PREFER_BINARY=1
  unset PIP_CONSTRAINT
  # shellcheck disable=SC2086
  if "${python}" -m pip install --dry-run --ignore-installed --no-deps --quiet --report /tmp/roslab-report ${options} \
    --requirement /tmp/roslab-requirements >"${log}" 2>&1; then
    printf 'report\t%s\t%s\n' "${environment}" "$(tr -d '\n\t' </tmp/roslab-report)"
    continue
  fi
  while read -r requirement; do
    rm -rf /tmp/roslab-files
    # shellcheck disable=SC2086
    "${python}" -m pip download --no-deps --quiet --dest /tmp/roslab-files ${options} "${requirement}" >"${log}" 2>&1 ||
      continue
    for file in /tmp/roslab-files/*; do
      if [ -f "${file}" ]; then
        printf 'file\t%s\t%s\t%s\n' "${environment}" "${requirement%%==*}" "$(sha256sum "${file}" | cut -d' ' -f1)"
      fi
    done
  done </tmp/roslab-requirements
done
exit 0
