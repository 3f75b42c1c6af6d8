#!/bin/bash
# usage: add-package-sources NAME...
# Adds package sources to apt's: ppa:OWNER/NAME, or a line "deb [signed-by=KEY] URL SUITE COMPONENT..." whose key is an address
# of https. One that does not answer is named and left out.
set -euo pipefail

add_line() {
  local key="${1#*signed-by=}"
  key="${key%%]*}"
  curl --fail --silent --show-error --location --proto '=https' --output "${keyring}.new" "${key}" || return 1
  if grep --quiet 'BEGIN PGP' "${keyring}.new"; then
    gpg --dearmor --yes --output "${keyring}" "${keyring}.new" || return 1
    rm "${keyring}.new"
  else
    mv "${keyring}.new" "${keyring}"
  fi
  if dpkg --compare-versions "$(dpkg-query --show --showformat '${Version}' apt)" lt 1.1; then
    apt-key add "${keyring}" # it does not know signed-by
  fi
  echo "${1/"${key}"/${keyring}}" >"${list}"
}
# An old release's add-apt-repository may not speak the TLS of Launchpad any more, which curl does
add_ppa() {
  local ppa="${1#ppa:}" fingerprint
  fingerprint="$(curl --fail --silent --show-error --location --proto '=https' \
    "https://api.launchpad.net/1.0/~${ppa%%/*}/+archive/ubuntu/${ppa#*/}" |
    sed --quiet --regexp-extended 's/.*"signing_key_fingerprint": ?"([0-9A-F]{40})".*/\1/p')"
  if [ -z "${fingerprint}" ]; then return 1; fi
  add_line "deb [signed-by=https://keyserver.ubuntu.com/pks/lookup?op=get&search=0x${fingerprint}] \
http://ppa.launchpad.net/${ppa}/ubuntu $(lsb_release --codename --short) main"
}

apt-get update
apt-get install --yes --no-install-recommends ca-certificates curl gnupg software-properties-common
number=0
for name in "$@"; do
  number=$((number + 1))
  keyring=/usr/share/keyrings/roslab-${number}.gpg
  list=/etc/apt/sources.list.d/roslab-${number}.list
  if [[ ${name} == "deb "* ]]; then
    if add_line "${name}" && apt-get update; then continue; fi
    rm --force "${list}" "${keyring}" "${keyring}.new"
  else
    if add-apt-repository --yes "${name}" && apt-get update; then continue; fi
    add-apt-repository --yes --remove "${name}" || true
    if add_ppa "${name}" && apt-get update; then continue; fi
    rm --force "${list}" "${keyring}" "${keyring}.new"
  fi
  echo "source ${name}" | tee --append /usr/local/share/roslab/left-out.txt
done
rm -rf /var/cache/{apt/*.bin,ldconfig/aux-cache} /var/log/{apt/[!h]*,alternatives.log,dpkg.log}
find /var/log/apt -name history.log -exec sed --in-place '/-Date: /d' {} +
