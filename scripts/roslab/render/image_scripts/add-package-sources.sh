#!/bin/bash
# usage: add-package-sources NAME...
# Adds package sources to apt's (ppa:OWNER/NAME). One that does not answer is named and left out.
set -euo pipefail

apt-get update
apt-get install --yes --no-install-recommends ca-certificates gnupg software-properties-common
for name in "$@"; do
  if ! { add-apt-repository --yes "${name}" && apt-get update; }; then
    add-apt-repository --yes --remove "${name}" || true
    echo "source ${name}" | tee --append /usr/local/share/roslab/left-out.txt
  fi
done
rm -rf /var/cache/{apt/*.bin,ldconfig/aux-cache} /var/log/{apt/[!h]*,alternatives.log,dpkg.log}
find /var/log/apt -name history.log -exec sed --in-place '/-Date: /d' {} +
