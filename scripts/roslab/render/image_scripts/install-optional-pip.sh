#!/bin/bash
# usage: install-optional-pip PYTHON [OPTION...] -- PACKAGE...
# Installs each package that pip finds, with the given options: those of a version that a page names first. Nothing is
# replaced that pip has installed by then, but for one of a version that cannot be had beside it. Of one that has not
# the exact version which a page names, one whose numbers begin so is taken (4.2.0 is 4.2.0.34), else any; what cannot
# be built by itself is built beside what is there (torch); `--no-build-isolation=PACKAGE` is built so first.
# `--no-deps=PACKAGE` is installed without what it asks for. `--editable=git+URL` is cloned and installed from its
# folder, which stays; where that fails, as any other. What asks for something that cannot be had is installed without
# it. What comes from git and asks pip for nothing gets, each if it can be had, what its own requirements.txt names and is
# not there. The others are named and left out. A program that a build lacks, or an older release of what builds, comes first
# (ask-pip-again). `--by-name=MODULE` is tried only because a module has that name: not where another has brought the
# module; where the newest release has no such module, the last one of the major version before is taken.
set -euo pipefail

source "$(command -v ask-pip-again)"
python="$1"
pip=(roslab_try "${python}" -m pip install)
shift
while [ "$1" != -- ]; do
  pip+=("$1")
  shift
done
shift
of_a_version=()
others=()
for package in "$@"; do
  line="${package#--no-build-isolation=}"
  line="${line#--no-deps=}"
  line="${line#--editable=}"
  line="${line#--by-name=}"
  case "${line%% @ *}" in *[\<=\>]*) of_a_version+=("${package}") ;; *) others+=("${package}") ;; esac
done
kept="$(mktemp)"
trap 'rm -f "${kept}"' EXIT # no layer keeps its name, which is another one each time
keep() {
  local folder
  folder="$(command "${python}" -c 'import site; print(site.getsitepackages()[0])')"
  command "${python}" -m pip list --format=freeze --path "${folder}" \
    | grep --extended-regexp '^[A-Za-z0-9._-]+==[0-9]+([.][0-9]+)*((a|b|rc|[.]post|[.]dev)[0-9]+)*([+][a-z0-9.]+)?$' >"${kept}" || true
}
has_module() {
  command "${python}" - "$1" <<'PYTHON'
import sys
try:
    from importlib.util import find_spec
except ImportError:  # Python 2
    from pkgutil import find_loader as find_spec
sys.path = [folder for folder in sys.path if folder]  # not what lies here
sys.exit(0 if find_spec(sys.argv[1]) else 1)
PYTHON
}
by_name() {
  local module="$1" version
  if has_module "${module}"; then
    echo "roslab: ${module} is there already: pip's package of that name may be another one, and is left out" >&2
    return
  fi
  if "${pip[@]}" --constraint "${kept}" "${module}" || "${pip[@]}" --no-build-isolation --constraint "${kept}" "${module}"; then
    if has_module "${module}"; then return; fi
    version="$(command "${python}" -m pip show "${module}" | sed --quiet 's/^Version: \([0-9]*\)[.].*/\1/p')"
    if [ "${version:-0}" -gt 0 ] && "${pip[@]}" --constraint "${kept}" "${module}<${version}" && has_module "${module}"; then
      echo "roslab: ${module} ${version} has no module ${module}: the release before ${version} is taken" >&2
      return
    fi
    echo "roslab: pip's package ${module} has no module ${module}: what imports it stops there" >&2
  fi
  echo "pip ${module}" | tee --append /usr/local/share/roslab/left-out.txt
}
# Tells whether the last call failed for something that the package asks for, and not for the package, as pip's log has it
for_another() { # PACKAGE
  local log="${notes:?}.log" packages name # ask-pip-again has pip write it
  packages="$(grep --count --extended-regexp ' (Collecting|Processing) ' "${log}" 2>/dev/null)"
  name="${1%% @ *}" && name="${name##*/}" && name="${name%%[[@#=<>~! ]*}" && name="${name%.git}"
  [ "${packages:-0}" -gt 1 ] \
    && ! grep --quiet --ignore-case --extended-regexp "Failed building wheel for ${name//[-_.]/[-_.]}\$" "${log}"
}
# Installs a package alone, and of what it asks for each that can be had
apart() { # PACKAGE
  local before name try line
  before="$(command "${python}" -m pip list --format=freeze)"
  for try in "${tries[@]}" failed; do
    if [ "${try}" = failed ]; then return 1; fi
    if install --no-deps ${try:+"${try}"} "$1"; then break; fi
  done
  echo "roslab: not all that $1 asks for can be had here: it is installed, and of that what can be had" >&2
  name="$(command "${python}" -m pip list --format=freeze \
    | grep --invert-match --line-regexp --fixed-strings --file=<(echo "${before}") | head -n 1)"
  keep
  while read -r line; do
    if ! install --constraint "${kept}" "${line}" </dev/null; then
      echo "pip ${line}" | tee --append /usr/local/share/roslab/left-out.txt
    fi
  done < <(if [ -n "${name}" ]; then roslab_asked "${python}" "${name%%==*}" ''; fi)
}
# Lists what is installed, as pip's names, each a line
names() { command "${python}" -m pip list --format=freeze | sed 's/[=@ ].*//' | tr 'A-Z_.' 'a-z--'; }
# Installs, of a package from git that asks pip for nothing, what its own list names and is not there: many say there alone
# what they need. In any version that can be had, for what is there stays.
of_list() { # git+URL NAMES-BEFORE
  local address="${1##*git+}" ref='' below='' folder line name new
  new="$(names | grep --invert-match --line-regexp --fixed-strings --file=<(echo "$2") || true)"
  if [ -z "${new}" ] || [ "${new}" != "${new%$'\n'*}" ] || [ -n "$(roslab_asked "${python}" "${new}" '')" ]; then return; fi
  case "${address}" in *subdirectory=*) below="${address##*subdirectory=}" && below="${below%%&*}/" ;; esac
  address="${address%%#*}"
  case "${address#*://*/}" in *@*) ref="${address##*@}" && address="${address%@*}" ;; esac
  folder="$(mktemp --directory)"
  if git clone --quiet --filter=blob:none "${address}" "${folder}/of" && git -C "${folder}/of" checkout --quiet ${ref:+"${ref}"} -- \
    && [ -e "${folder}/of/${below}requirements.txt" ]; then
    echo "roslab: ${new} asks pip for nothing: what its own requirements.txt names comes with it" >&2
    keep
    while read -r line; do
      line="$(sed 's/\r$//; s/[[:space:]]*#.*//' <<<"${line}")"
      name="${line%%[<>=!~;[ @]*}"
      case "${line}" in '' | -* | .* | */*) continue ;; esac
      if grep --quiet --line-regexp --fixed-strings "$(tr 'A-Z_.' 'a-z--' <<<"${name}")" <<<"$(names)"; then continue; fi
      if ! { install --constraint "${kept}" "${line}" || install --constraint "${kept}" "${name}"; } </dev/null; then
        echo "pip ${line}" | tee --append /usr/local/share/roslab/left-out.txt
      fi
    done < <(cat "${folder}/of/${below}requirements.txt" && echo)
  fi
  rm -rf "${folder}"
}
alone=() # what --no-deps=PACKAGE adds
install() { "${pip[@]}" ${alone[@]+"${alone[@]}"} "$@"; }
for package in ${of_a_version[@]+"${of_a_version[@]}"} -- ${others[@]+"${others[@]}"}; do
  tries=("" --no-build-isolation)
  case "${package}" in --no-build-isolation=*) tries=(--no-build-isolation "") ;; esac
  package="${package#--no-build-isolation=}"
  alone=()
  if [ "${package}" != "${package#--no-deps=}" ]; then
    package="${package#--no-deps=}"
    alone=(--no-deps)
  fi
  if [ "${package}" != "${package#--editable=}" ]; then
    package="${package#--editable=}"
    if folder="$(clone-editable "${package}")"; then
      for try in "${tries[@]}"; do
        if install ${try:+"${try}"} --editable "${folder}"; then
          clone-editable --installed "${package}"
          continue 2
        fi
      done
      echo "roslab: pip cannot install ${package} editable here: it is installed from elsewhere" >&2
    fi
  fi
  case "${package}" in
    --) keep && continue ;;
    --by-name=*) by_name "${package#--by-name=}" && continue ;;
    *://*) limits=() ;;
    *[\<=\>]*)
      keep # what is there may have the release that a list limits it to, of which this call of pip knows nothing
      if [ -s "${kept}" ] && install ${tries[0]:+"${tries[0]}"} --constraint "${kept}" "${package}"; then continue; fi
      limits=()
      ;;
    *) limits=(--constraint "${kept}") ;;
  esac
  another=''
  before=''
  case "${package}" in *git+*) if [ "${#alone[@]}" -eq 0 ]; then before="$(names)"; fi ;; esac
  for try in "${tries[@]}"; do
    if install ${try:+"${try}"} ${limits[@]+"${limits[@]}"} "${package}"; then
      if [ -n "${before}" ]; then of_list "${package}" "${before}"; fi
      continue 2
    fi
    if [ "${#alone[@]}" -eq 0 ] && for_another "${package}"; then another=yes; fi
  done
  name="${package%%==*}"
  case "${package#"${name}"}" in
    == | *[!0-9.=]*) ;;
    ==*)
      if install "${package}.*"; then
        echo "roslab: pip cannot install ${package} here: a version of ${package}.* is taken" >&2
        continue
      fi
      ;;
  esac
  if [ "${name}" != "${package}" ] && install "${name}"; then
    echo "roslab: pip cannot install ${package} here: another version is taken" >&2
    continue
  fi
  if [ -n "${another}" ] && apart "${package}"; then continue; fi
  echo "pip ${package}" | tee --append /usr/local/share/roslab/left-out.txt
done
if command -v clone-editable >/dev/null; then clone-editable --tidy; fi
