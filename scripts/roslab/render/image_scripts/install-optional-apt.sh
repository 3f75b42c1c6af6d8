#!/bin/bash
# usage: install-optional-apt PACKAGE...
# Installs the packages that apt knows, together where that works, else one by one. The others are named and left out.
set -euo pipefail

left_out=/usr/local/share/roslab/left-out.txt
said=/tmp/install-optional-apt
# A name with a plus that apt does not have is a pattern to it: g++-14 is found in clang-14
install=(apt-get install -oAPT::Cmd::Pattern-Only=true --yes --no-remove --no-install-recommends)
known=("$@")
possible() { LC_ALL=C "${install[@]}" --simulate "$@" >/dev/null 2>"${said}"; }

apt-get update --option pkgCacheFile::Generate=false # the next call makes what it needs
# All at once first, for each call of apt reads all its lists anew: then without what it says that it does not have
if ! possible "$@"; then
  unknown="s/^E: (Unable to locate package|Package) '?([^ ']+)'?( has no installation candidate)?$/\2/p"
  mapfile -t known < <(grep -vxFf <(sed --quiet --regexp-extended "${unknown}" "${said}") <(printf '%s\n' "$@"))
  if [ "${#known[@]}" -gt 0 ] && ! possible "${known[@]}"; then
    known=()
    for package in "$@"; do if possible "${package}"; then known+=("${package}"); fi; done
  fi
  for package in "$@"; do
    if [[ " ${known[*]-} " != *" ${package} "* ]]; then echo "apt ${package}" >>"${left_out}"; fi
  done
fi
rm "${said}"
if [ "${#known[@]}" -gt 0 ] && ! "${install[@]}" "${known[@]}"; then
  for package in "${known[@]}"; do
    "${install[@]}" "${package}" || echo "apt ${package}" >>"${left_out}"
  done
fi
if [ -s "${left_out}" ]; then sed 's/^/roslab: left out: /' "${left_out}"; fi
rm -rf /var/cache/{apt/*.bin,ldconfig/aux-cache} /var/log/{apt/[!h]*,alternatives.log,dpkg.log}
find /var/log/apt -name history.log -exec sed --in-place '/-Date: /d' {} +
