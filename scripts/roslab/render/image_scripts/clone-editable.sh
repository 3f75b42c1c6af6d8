#!/bin/bash
# usage: clone-editable git+URL[@REF][#subdirectory=FOLDER]    clones it below /opt/cloned, and prints the folder for pip
#        clone-editable --installed git+URL...                 notes that pip installed it, with its commit
#        clone-editable --tidy                                 leaves what is noted, without what differs each time
# Fails where it cannot be cloned, and where the project would compile itself again when it is imported: meson-python and
# scikit-build-core do (what they need is gone by then), or forbid to be installed so (`disable_editable`).
set -euo pipefail

src=/opt/cloned
notes=/usr/local/share/roslab/clones

if [ "$1" = --tidy ]; then
  if [ ! -e "${src}" ]; then exit; fi
  for folder in "${src}"/*/; do
    folder="${folder%/}"
    if [ ! -e "${folder}/.git" ]; then continue; fi
    noted=(--regexp "${folder}/" --regexp "${folder}"$'\t')
    if ! grep --quiet --no-messages --fixed-strings "${noted[@]}" "${notes}"; then rm -rf "${folder}"; fi
  done
  # What git keeps has times, and so has what Python and ninja remember of a build
  find "${src}" \( -name .git -o -name __pycache__ -o -name .ninja_log -o -name .ninja_deps \) -prune -exec rm -rf {} +
  rmdir --ignore-fail-on-non-empty "${src}"
  exit
fi

installed=''
if [ "$1" = --installed ]; then installed=yes && shift; fi
url="${1#git+}" ref='' below=''
case "${url}" in *"#"*) below="${url#*"#"}" ;; esac
url="${url%%"#"*}"
below="$(sed --quiet --regexp-extended 's/^(.*&)?subdirectory=([^&]*).*/\2/p' <<<"${below}")"
path="${url#*://*/}" # a login before it has an @ too
if [ "${path}" != "${path%@*}" ]; then
  ref="${path##*@}"
  url="${url%@"${ref}"}"
fi
name="${url%/}"
name="${name##*/}"
folder="${src}/${name%.git}"
project="${folder}${below:+"/${below}"}"

if [ "${installed}" ]; then
  printf '%s\t%s\t%s\t%s\n' "${project}" "${url}" "$(git -C "${folder}" rev-parse HEAD)" "${below}" >>"${notes}"
  exit
fi
if [ ! -e "${folder}" ]; then
  mkdir --parents "${src}"
  { git clone --quiet --filter=blob:none "${url}" "${folder}" || git clone --quiet "${url}" "${folder}"; } >&2
  if ! { git -C "${folder}" checkout --quiet ${ref:+"${ref}"} -- \
    && git -C "${folder}" submodule --quiet update --init --recursive; } >&2; then
    rm -rf "${folder}"
    exit 1
  fi
elif [ "$(git -C "${folder}" config --get remote.origin.url)" != "${url}" ]; then
  exit 1 # another one of this name
fi
if [ ! -e "${project}/setup.py" ] && [ ! -e "${project}/pyproject.toml" ]; then exit 1; fi
again='mesonpy|meson-python|scikit[-_]build[-_]core|disable_editable *= *True'
files=("${project}/setup.py" "${project}/pyproject.toml")
if grep --quiet --no-messages --extended-regexp "${again}" "${files[@]}"; then exit 1; fi
echo "${project}"
