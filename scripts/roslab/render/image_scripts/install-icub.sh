#!/bin/bash
# usage: install-icub UBUNTU
# Installs the iCub's packages for an Ubuntu's code name. Where they are served no more, they are named and left out.
set -euo pipefail

key='https://keyserver.ubuntu.com/pks/lookup?op=get&search=0x57A5ACB6110576A6'
keyring=/usr/share/keyrings/icub.gpg
list=/etc/apt/sources.list.d/icub.list
source="deb [signed-by=${keyring}] http://www.icub.org/ubuntu $1 contrib/science"

apt-get update
apt-get install --yes --no-install-recommends curl gnupg
if ! { curl --fail --silent --show-error --location "${key}" | gpg --dearmor --output "${keyring}" &&
  echo "${source}" >"${list}" && apt-get update && apt-get install --yes --no-install-recommends icub; }; then
  rm --force "${list}"
  echo "apt icub" | tee --append /usr/local/share/roslab/left-out.txt
fi
rm -rf /var/cache/{apt/*.bin,ldconfig/aux-cache} /var/log/{apt/[!h]*,alternatives.log,dpkg.log}
find /var/log/apt -name history.log -exec sed --in-place '/-Date: /d' {} +
