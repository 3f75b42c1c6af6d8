#!/bin/bash
# usage: create-user [--ssh]
#   --ssh  addresses of ssh stay as they are, for the build has a key
# Makes the image's user, ${NB_USER} with the number ${NB_UID}: Binder's names.
# Ubuntu 24.04 and newer come with a user of that number, which is renamed.
set -euo pipefail

present="$(getent passwd "${NB_UID}" | cut -d: -f1)" || true
if [ -z "${present}" ]; then
  useradd --create-home --user-group --uid "${NB_UID}" --shell /bin/bash "${NB_USER}"
elif [ "${present}" != "${NB_USER}" ]; then
  usermod --login "${NB_USER}" --home "/home/${NB_USER}" --move-home --shell /bin/bash "${present}"
  groupmod --new-name "${NB_USER}" "$(id --group --name "${NB_UID}")"
fi
IFS=: read -r _ _ _ group _ home _ < <(getent passwd "${NB_UID}")
# What programs take for granted: one that makes a folder below these may not make them
for folder in "${home}"/{.cache,.config,.local,.local/share}; do
  install --directory --owner="${NB_UID}" --group="${group}" "${folder}"
done
# Code hosts no longer answer by git://, and an image has nobody's key: CMake, submodules and scripts of other times
while read -r host; do
  echo "[url \"https://${host}/\"]"
  printf '\tinsteadOf = %s\n' "git://${host}/"
  if [ "${1:-}" != --ssh ]; then printf '\tinsteadOf = %s\n' "git@${host}:" "ssh://git@${host}/"; fi
done </usr/local/share/roslab/git-hosts.txt >>/etc/gitconfig
mkdir --parents /usr/local/share/roslab
# What makes ROS and the workspace known to every shell, where the image has either
environment=/usr/local/share/roslab/environment.bash
echo "if [ -e ${environment} ]; then source ${environment}; fi" >>/etc/bash.bashrc
# What the base brought: `roslab lock` tells it from what the steps below install
# Without the architecture that dpkg puts behind the name of a library
dpkg-query --show --showformat '${Package}\t${Version}\n' >/usr/local/share/roslab/base-packages
