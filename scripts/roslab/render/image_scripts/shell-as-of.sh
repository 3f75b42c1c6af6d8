#!/bin/bash
# usage: SHELL ["/usr/local/bin/shell-as-of", "DAY"], of an image that a Dockerfile starts from
# Runs a step of that Dockerfile by /bin/sh, as Docker does. One that may call pip has the index as it was at the end of a
# day (index-as-of, with today's where nothing of that day would do), and an older wheel before the source of a newer release.
# One that may call git has the heads of that day (git-as-of). Each where the image has that script.
set -euo pipefail

day="$1"
step="$2"
if command -v index-as-of >/dev/null &&
  grep --quiet --extended-regexp '\bpip|\bconda\b|\bmamba\b|\bsetup\.py\b|\.sh\b' <<<"${step}"; then
  export PIP_PREFER_BINARY=1
  given="$(index-as-of "${day}" --or-today | grep '^export ' || true)"
  eval "${given}"
fi
if command -v git-as-of >/dev/null && [ -z "${GIT_AS_OF:-}" ] &&
  grep --quiet --extended-regexp '\bgit\b|\bvcs\b|\bwstool\b|\brosinstall\b|\.sh\b' <<<"${step}"; then
  given="$(git-as-of "${day}")"
  eval "${given}"
fi
exec /bin/sh -c "${step}"
