#!/bin/sh
# Prints what this image is made of, one thing a line, fields parted by tabs. Runs in the image, as root; changes nothing.
#   apt NAME VERSION ARCHITECTURE SOURCE      a package that dpkg has
#   base NAME VERSION                         one that the base brought, in a generated image
#   history LINE                              apt's own record of what each call installed
#   python ENVIRONMENT NAME VERSION INSTALLER DIRECT-URL
#   clone FOLDER URL COMMIT SUBFOLDER         a folder of a repository that pip installed editable
#   conda URL                                 a package of the conda environment, with its MD5 sum
#   source NAME URL COMMIT                    a repository that was cloned
set -u
tab="$(printf '\t')"

if command -v dpkg-query >/dev/null 2>&1; then
  dpkg-query --show --showformat '${db:Status-Status}\t${Package}\t${Version}\t${Architecture}\t${source:Package}\n' |
    sed -n "s/^installed${tab}/apt${tab}/p"
fi
if [ -r /usr/local/share/roslab/base-packages ]; then
  sed "s/^/base${tab}/" /usr/local/share/roslab/base-packages
fi
if [ -r /var/log/apt/history.log ]; then
  grep -E '^(Commandline|Install|Upgrade): ' /var/log/apt/history.log | sed "s/^/history${tab}/"
fi

field() { awk -v name="$2: " 'index($0, name) == 1 { print substr($0, length(name) + 1); exit }' "$1" | tr -d '\r\t'; }

packages() {
  "$2" -c 'import sys; print("\n".join(p for p in sys.path if p))' 2>/dev/null | while read -r folder; do
    case "${folder}" in
      /usr/lib/python3/dist-packages | /usr/lib/python2.7/dist-packages) continue ;; # these are apt's
    esac
    for found in "${folder}"/*.dist-info/METADATA "${folder}"/*.egg-info/PKG-INFO "${folder}"/*.egg-info; do
      if [ ! -f "${found}" ]; then continue; fi
      direct='' installer=''
      case "${folder}" in *-packages) ;; *) direct="{\"url\": \"file://${folder}\"}" ;; esac # an old pip's editable one
      if [ -r "${found%/*}/direct_url.json" ]; then direct="$(tr -d '\n\r\t' <"${found%/*}/direct_url.json")"; fi
      if [ -r "${found%/*}/INSTALLER" ]; then installer="$(tr -d '\n\r\t ' <"${found%/*}/INSTALLER")"; fi
      printf 'python\t%s\t%s\t%s\t%s\t%s\n' "$1" "$(field "${found}" Name)" "$(field "${found}" Version)" \
        "${installer}" "${direct}"
    done
  done
}

for python in python3 python; do
  if command -v "${python}" >/dev/null 2>&1; then
    packages image "${python}"
    break
  fi
done
if command -v python2 >/dev/null 2>&1; then packages python2 python2; fi
if [ -x /opt/jupyter/bin/python ]; then packages jupyter /opt/jupyter/bin/python; fi

if [ -r /usr/local/share/roslab/clones ]; then sed "s/^/clone${tab}/" /usr/local/share/roslab/clones; fi

for found in "${CONDA_PREFIX:-/opt/conda}"/conda-meta/*.json; do
  if [ ! -f "${found}" ]; then continue; fi
  # The last of each name: the record's own, after those of its parts
  awk -F'"' '/^ *"url": "/ { url = $4 } /^ *"md5": "/ { md5 = $4 } END { if (url) print "conda\t" url "#" md5 }' "${found}"
done

if command -v git >/dev/null 2>&1; then
  for found in "${HOME:-/root}"/*/src/*/.git "/home/${NB_USER:-jovyan}"/*/src/*/.git; do
    folder="${found%/.git}"
    if [ ! -e "${found}" ]; then continue; fi
    url="$(git -c safe.directory='*' -C "${folder}" config --get remote.origin.url)" || continue
    commit="$(git -c safe.directory='*' -C "${folder}" rev-parse HEAD)" || continue
    printf 'source\t%s\t%s\t%s\n' "${folder##*/}" "${url}" "${commit}"
  done
fi
for found in /usr/local/share/roslab/sources/*; do
  if [ -f "${found}" ]; then printf 'source\t%s\n' "$(cat "${found}")"; fi
done
exit 0
