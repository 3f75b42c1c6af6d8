#!/bin/bash
# usage: renew-package-sources [--ros URL SUITE KEY] [--or URL] [--add] [--ended] [--after DAY OPTION...]
# Makes the package sources of a base answer again, before anything is installed.
#   --ros URL SUITE KEY  ROS's packages come from here, signed by the key of that name; replaces the base's own source
#   --or URL             where that does not answer, take this, signed by the same key; own: the base's own source
#   --add                also where the base has no source of ROS
#   --ended              try each source: a release of Ubuntu or Debian that was moved is taken from the archive; what
#                        is not there, or is signed by a key that this base cannot know, is named and left out
#   --after DAY OPTION.. what follows is done once that day (YYYY-MM-DD) is past: the base will have ended then
set -euo pipefail

here=/usr/local/share/roslab
log=/tmp/apt-update
shopt -s nullglob
url='' suite='' key='' other='' add='' ended=''
mkdir --parents "${here}"
while [ $# -gt 0 ]; do
  case "$1" in
    --ros) url="$2" suite="$3" key="$4" && shift 3 ;;
    --or) other="$2" && shift ;;
    --add) add=yes ;;
    --ended) ended=yes ;;
    --after)
      if [[ ! "$(date --utc +%F)" > "$2" ]]; then break; fi
      other=own && shift # a distribution's last snapshot may come long after its end
      ;;
  esac
  shift
done

sources() {
  local files=(/etc/apt/sources.list.d/*.list /etc/apt/sources.list.d/*.sources)
  if [ -e /etc/apt/sources.list ]; then files+=(/etc/apt/sources.list); fi
  printf '%s\n' "${files[@]}"
}

use_ros() {
  local file found="${add}" keyring="/usr/share/keyrings/roslab-${key}.gpg"
  while read -r file; do
    if grep --quiet --extended-regexp '(packages|snapshots)\.ros\.org/' "${file}"; then
      found=yes
      case "${file}" in
        *.sources) rm "${file}" ;;
        *) sed --in-place --regexp-extended '/(packages|snapshots)\.ros\.org\//d' "${file}" ;;
      esac
    fi
  done < <(sources)
  if [ -z "${found}" ]; then return; fi
  mkdir --parents "${keyring%/*}"
  # The armour's lines around the key's base64; older bases read no armoured key, and have no gpg to unpack it
  sed --expression '1,/^$/d' --expression '/^[=-]/d' "${here}/${key}.asc" | base64 --decode >"${keyring}"
  if dpkg --compare-versions "$(dpkg-query --show --showformat '${Version}' apt)" lt 1.1; then
    apt-key add "${here}/${key}.asc" # it does not know signed-by
  fi
  echo "deb [signed-by=${keyring}] ${url} ${suite} main" >/etc/apt/sources.list.d/roslab-ros.list
  echo "roslab: ROS comes from ${url} ${suite}"
}

# Prints URL and SUITE of what apt refused for a reason that lasts; a server that cannot be reached is none
refused() {
  # Without the cache of all packages that apt would make of the lists: nothing is installed here
  LC_ALL=C apt-get update --option pkgCacheFile::Generate=false >"${log}" 2>&1 || true
  awk '
    function tell(url, suite) { sub(/\/$/, "", url); sub(/\/$/, "", suite); print url, suite }
    /^Err/ { at = $2; of = $3 ~ /^(In)?Release/ ? "" : $3; next }
    /^ +(404|410) / { if (at ~ /:\/\/[^\/]+\/./) tell(at, of) }
    { at = "" }
    /^[WE]: Failed to fetch .*\/dists\/.* (404|410) / {
      split($5, part, "/dists/")
      rest = part[2]
      sub(/\/(main|restricted|universe|multiverse|contrib|non-free|(In)?Release)(\/.*|\.gpg)?$/, "", rest)
      tell(part[1], rest)
    }
    /^[WE]: GPG error: .*(NO_PUBKEY|EXPKEYSIG|KEYEXPIRED|REVKEYSIG)/ {
      tell($4, $5 ~ /^(In)?Release/ ? "" : $5)
    }' "${log}" | sort --unique
}

# Ubuntu and Debian move a release to their archive some time after its end; archives.txt says which is whose
use_archive() {
  local file pattern archive
  while read -r file; do
    if ! grep --quiet --fixed-strings "$1" "${file}"; then continue; fi
    while read -r pattern archive; do
      sed --in-place --regexp-extended "s#${pattern}#${archive}#" "${file}"
    done <"${here}/archives.txt"
  done < <(sources)
}

# Takes the other source of ROS where the first does not answer
use_other() {
  refused >"${log}.refused"
  if ! grep --quiet --fixed-strings "${url} " "${log}.refused"; then return; fi
  echo "source ${url}: ${other} is taken" | tee --append "${here}/left-out.txt"
  if [ "${other}" = own ]; then
    rm /etc/apt/sources.list.d/roslab-ros.list
    cp --recursive /tmp/own-sources/. /etc/apt/
  else
    sed --in-place "s#${url}#${other}#" /etc/apt/sources.list.d/roslab-ros.list
  fi
}

leave_out() {
  local file
  echo "source $1 $2" | tee --append "${here}/left-out.txt"
  while read -r file; do
    if ! grep --quiet --fixed-strings "$1" "${file}"; then continue; fi
    case "${file}" in
      *.sources)
        awk -v url="$1" -v suite="$2" '
          BEGIN { RS = ""; ORS = "\n\n" }
          !index($0, url) { print; next }
          {
            kept = ""
            lines = split($0, line, "\n")
            for (i = 1; i <= lines; i++) {
              if (line[i] !~ /^Suites:/) { kept = kept line[i] "\n"; continue }
              words = split(line[i], word, " ")
              others = ""
              for (j = 2; j <= words; j++) if (word[j] != suite && word[j] != suite "/") others = others " " word[j]
              kept = kept "Suites:" others (others == "" ? " none\nEnabled: no" : "") "\n"
            }
            sub(/\n$/, "", kept)
            print kept
          }' "${file}" >"${file}.new"
        ;;
      *)
        awk -v url="$1" -v suite="$2" '
          {
            plain = $0
            sub(/\[[^]]*\]/, "", plain)
            split(plain, word, " ")
            sub(/\/$/, "", word[2])
            sub(/\/$/, "", word[3])
            print (word[1] ~ /^deb/ && word[2] == url && word[3] == suite ? "# left out: " : "") $0
          }' "${file}" >"${file}.new"
        ;;
    esac
    cat "${file}.new" >"${file}"
    rm "${file}.new"
  done < <(sources)
}

if [ -n "${url}" ]; then
  mkdir --parents /tmp/own-sources
  cp --recursive /etc/apt/sources.list* /tmp/own-sources
  use_ros
  if [ -n "${other}" ] && [ -e /etc/apt/sources.list.d/roslab-ros.list ]; then use_other; fi
  rm -rf /tmp/own-sources
fi
if [ -n "${ended}" ]; then
  refused >"${log}.refused"
  if cut --delimiter ' ' --fields 1 "${here}/archives.txt" | grep --quiet --extended-regexp --file - "${log}.refused"; then
    while read -r at _; do use_archive "${at}"; done <"${log}.refused"
    echo 'Acquire::Check-Valid-Until "false";' >/etc/apt/apt.conf.d/99roslab-archive # an archive is not signed anew
    echo "roslab: this release is taken from its archive"
    refused >"${log}.refused"
  fi
  while read -r at of; do leave_out "${at}" "${of}"; done <"${log}.refused"
  rm -rf "${log}" "${log}.refused"
fi
