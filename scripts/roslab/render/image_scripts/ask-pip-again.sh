#!/bin/bash
# usage: source ask-pip-again
# For a shell that reads it: calls pip again where it failed for something that can be done about. Where the requirements
# contradict each other, the first that names a package decides, as in pip before 20.3: many lists were never resolved as a
# whole. Where a package cannot be built with a new Cython or setuptools, as its messages say (build-limits.txt), an older one
# builds it: where packages are built apart, by a constraint; where that did not help, pip installs it beside them. A program
# or module that a package is built with and does not ask pip for (build-programs.txt) is installed by pip. Where its setup
# script imports what is installed and pip hides from it, it is built beside what is installed. What apt installed and pip
# cannot remove stays, and pip's own comes before it. Where an older pip takes a package, as pip's message says, it gets that
# pip. An exact version that is gone from the index becomes the next one with the same first two numbers, if there is one. A
# lower bound that no release reaches is left out; where a project asks for it, what it asks for is installed as a list. Where
# index-as-of serves the index of a day (--or-today) and a lower bound is newer than it, that package's newer versions are
# there the next time. So are those of a package whose archive lacks a file that its setup script reads: nobody can build
# it; without a day, or where the newest lacks it too, the release before it is taken.
# What a package prints while it is built is shown at the end: a pip that writes a log has it there alone.
set -eo pipefail # as the steps that read it have
notes="${INDEX_AS_OF:-$(mktemp -u /dev/shm/ask-pip-again.XXXXXX)}" # with what each is after this name

roslab_pip() {
  local log="${notes}.log"
  if [ "${2:-} ${3:-}" != '-m pip' ]; then
    command "$@"
    return
  fi
  if roslab_call "$@"; then return; fi
  roslab_show
}
# For packages that need not be had: what pip takes stays as it is, and only what builds it may change
roslab_try() { # CALL...
  local log="${notes}.log" call=("$@")
  until rm -f "${log}" && PIP_LOG="${log}" command "${call[@]}"; do
    if roslab_builder "$1" || roslab_incomplete; then continue; fi
    roslab_show || return 1
  done
}
roslab_show() { # without the times of the log's lines
  grep -m 1 -B 60 -E 'ERROR: .*(exited with|errored out)' "${log}" 2>/dev/null | sed 's/^[0-9T:,-]* //' >&2 || true
  return 1
}
roslab_call() {
  local first=--use-deprecated=legacy-resolver name
  local call=("$@")
  until rm -f "${log}" && PIP_LOG="${log}" command "${call[@]}"; do
    if grep -q -E 'Cannot install .* conflicting dependencies|error: resolution-too-deep' "${log}" 2>/dev/null && [ "${call[-1]}" != "${first}" ]; then
      sed -n 's/.*\(Cannot install .* conflicting dependencies\).*/roslab: \1/p' "${log}" | head -n 1 >&2
      echo "roslab: the first requirement that names a package decides, as in pip before 20.3" >&2
      call+=("${first}")
      continue
    fi
    if roslab_builder "${call[0]}" || roslab_older_pip "${call[0]}" || roslab_covered "${call[0]}"; then continue; fi
    if roslab_incomplete; then continue; fi
    name="$(sed -n 's/.*No matching distribution found for \([A-Za-z0-9._-]*\).*/\1/p' "${log}" 2>/dev/null | tail -n 1)"
    if [ -z "${name}" ]; then return 1; fi
    if [ -z "${INDEX_AS_OF:-}" ] || grep -q -x -F "${name}" "${INDEX_AS_OF}" 2>/dev/null; then
      roslab_next_version "${name}" || roslab_out_of_reach "${call[0]}" "${name}" || return 1
      continue
    fi
    echo "${name}" >>"${INDEX_AS_OF}"
    echo "roslab: no version of ${name} that was there on the day fits what is asked for: newer ones are taken" >&2
  done
}
# Changes what builds a package, or where it is built, so that the call is worth another try
roslab_builder() { # PYTHON
  roslab_older_builder "$1" || roslab_program "$1" || roslab_beside "$1"
}
# Takes an older release of what builds packages, where the output says that a package does not suit it
roslab_older_builder() { # PYTHON
  local package below python pattern older limits=/usr/local/share/roslab/build-limits.txt
  if [ ! -e "${limits}" ]; then return 1; fi
  while read -r package below python pattern; do
    if ! grep -q -E "${pattern}" "${log}" 2>/dev/null; then continue; fi
    older="${package}<${below}"
    if ! grep -q -x -F "${older}" "${notes}.older" 2>/dev/null; then
      echo "${older}" >>"${notes}.older"
      echo "roslab: what is built here does not suit ${package} ${below} and newer: an older one is taken" >&2
      # Until 25.3 all constraints of pip hold where it builds, from then on these alone
      export PIP_BUILD_CONSTRAINT="${notes}.older"
      if command "$1" -m pip install --help </dev/null | grep -e --build-constraint >/dev/null; then return; fi
      case " ${PIP_CONSTRAINT:-} " in
        *" ${notes}.older "*) ;;
        *) export PIP_CONSTRAINT="${PIP_CONSTRAINT:+${PIP_CONSTRAINT} }${notes}.older" ;;
      esac
      return
    fi
    if roslab_newer_beside "$1" && ! grep -q -x -F "${older}" "${notes}.beside" 2>/dev/null; then
      echo "${older}" >>"${notes}.beside"
      echo "roslab: it is built beside what is installed: pip installs ${older}" >&2
      command "$1" -m pip install --no-cache-dir "${older}" </dev/null
      return
    fi
  done <"${limits}"
  return 1
}
# Tells whether a release of $package that is too new is installed, and older ones run on this Python
roslab_newer_beside() { # PYTHON
  local version
  if command "$1" -c "import sys; sys.exit(sys.version_info < (${python/./, }))"; then return 1; fi
  version="$(command "$1" -m pip show "${package}" 2>/dev/null </dev/null | sed -n 's/^Version: //p')"
  [ "$(printf '%s\n' "${below}" "${version:-0}" | sort -V | head -n 1)" = "${below}" ]
}
# Installs a program or module that a build lacks, each once
roslab_program() { # PYTHON
  local package pattern programs=/usr/local/share/roslab/build-programs.txt
  if [ ! -e "${programs}" ]; then return 1; fi
  while read -r package pattern; do
    if grep -q -E "${pattern}" "${log}" 2>/dev/null && ! grep -q -x -F "${package}" "${notes}.programs" 2>/dev/null; then
      echo "${package}" >>"${notes}.programs"
      echo "roslab: what is built here lacks a program or module: pip installs ${package}" >&2
      command "$1" -m pip install --no-cache-dir "${package}" </dev/null
      return
    fi
  done <"${programs}"
  return 1
}
# Has packages built beside what is installed, where a setup script imports of that what pip hides from it
roslab_beside() { # PYTHON
  local module
  module="$(sed -n "s/.*ModuleNotFoundError: No module named '\([A-Za-z0-9_]*\).*/\1/p" "${log}" 2>/dev/null | tail -n 1)"
  case " ${call[*]} " in
    *" --no-build-isolation "*) return 1 ;;
  esac
  if [ -z "${module}" ] || ! command "$1" -c "import ${module}" >/dev/null 2>&1; then return 1; fi
  echo "roslab: what is built here imports ${module} and does not ask for it: it is built beside what is installed" >&2
  command "$1" -m pip install --no-cache-dir setuptools wheel </dev/null || return 1
  call+=(--no-build-isolation)
}
# Takes the pip that reads a package's metadata, which newer ones refuse, or that installs in place by an old setuptools: from
# 25.3 on pip calls no `setup.py develop` (https://pip.pypa.io/en/stable/news/)
roslab_older_pip() { # PYTHON
  local older said='has metadata that this pip refuses'
  older="$(sed -n 's/.*Please use \(pip<[0-9.]*[0-9]\) if you need to use this version.*/\1/p' "${log}" 2>/dev/null | tail -n 1)"
  if grep -q "missing the 'build_editable' hook" "${log}" 2>/dev/null; then
    older='pip<25.3' said='has a setuptools by which this pip installs nothing in place'
  fi
  if [ -z "${older}" ] || grep -q -x -F "${older}" "${notes}.pip" 2>/dev/null; then return 1; fi
  echo "${older}" >>"${notes}.pip"
  echo "roslab: a package ${said}: ${older} is taken" >&2
  command "$1" -m pip install --no-cache-dir "${older}" </dev/null
}
# Has another release taken than one whose archive lacks a file that its setup script reads, unless it is asked for by number
roslab_incomplete() {
  local lacked name version
  # The last line of a traceback that does not end in a program which is called and not there
  lacked="$(awk '
    /Traceback \(most recent call last\)/ { called = 0 }
    /_execute_child/ { called = 1 }
    match($0, /(FileNotFoundError|IOError): \[Errno 2\] No such file or directory: .[^\/]|(FileNotFoundError|IOError): .*\/pip-[a-z-]+-[a-z0-9_]+\//) {
      if (!called) lacked = file
    }
    / Collecting / { lacked = "" }
    match($0, /(Downloading|Using cached) [^ ]+[.](tar[.](gz|bz2)|zip)/) { file = substr($0, RSTART, RLENGTH) }
    /did not run successfully|exited with 1|errored out with exit status/ { found = lacked }
    END { print found }' "${log}" 2>/dev/null)"
  if ! [[ "${lacked##*[ /]}" =~ ^(.+)-([0-9][^-]*)[.](tar[.](gz|bz2)|zip)$ ]]; then return 1; fi
  name="${BASH_REMATCH[1]}" version="${BASH_REMATCH[2]}"
  if grep -q -i -E "(Collecting|Processing) ${name//[-_.]/[-_.]}(\[[^]]*\])?=" "${log}"; then return 1; fi
  if [ -n "${INDEX_AS_OF:-}" ] && ! grep -q -x -F "${name}" "${INDEX_AS_OF}" 2>/dev/null; then
    echo "${name}" >>"${INDEX_AS_OF}"
    echo "roslab: the archive of ${name} ${version} lacks what builds it: a newer release is taken" >&2
    return
  fi
  # Each release once, and few of them: a package may never have had what builds it
  if grep -q -x -F "${name}!=${version}" "${notes}.incomplete" 2>/dev/null; then return 1; fi
  if [ "$(grep -c -F "${name}!=" "${notes}.incomplete" 2>/dev/null || true)" -ge 5 ] 2>/dev/null; then return 1; fi
  echo "${name}!=${version}" >>"${notes}.incomplete"
  echo "roslab: the archive of ${name} ${version} lacks what builds it: the release before it is taken" >&2
  case " ${PIP_CONSTRAINT:-} " in
    *" ${notes}.incomplete "*) ;;
    *) export PIP_CONSTRAINT="${PIP_CONSTRAINT:+${PIP_CONSTRAINT} }${notes}.incomplete" ;;
  esac
}
# Installs before what apt installed the version of it that pip wants, each once: pip cannot remove apt's
roslab_covered() { # PYTHON
  local name like version
  name="$(sed -n "s/.*[Cc]annot uninstall '\{0,1\}\([A-Za-z0-9_.-]*[A-Za-z0-9]\)['., ].*/\1/p" "${log}" 2>/dev/null | tail -n 1)"
  if [ -z "${name}" ] || grep -q -x -F "${name}" "${notes}.covered" 2>/dev/null; then return 1; fi
  echo "${name}" >>"${notes}.covered"
  like="${name//[-_.]/[-_.]}"
  version="$(grep -o -i -E "(Downloading|Using cached) [^ ]*\b${like}-[0-9][A-Za-z0-9.!+]*(-|[.]tar|[.]zip)" "${log}" | tail -n 1 \
    | sed "s/.*-\([0-9][A-Za-z0-9.!+]*\)-\{0,1\}\$/\1/; s/[.]\(tar\|zip\)\$//")"
  if [ -z "${version}" ]; then return 1; fi
  echo "roslab: pip cannot remove ${name} of another installer: it stays, and ${version} is installed before it" >&2
  command "$1" -m pip install --no-cache-dir --ignore-installed --no-deps "${name}==${version}" </dev/null
}
# Leaves a lower bound out that no release reaches, for whatever Python: nobody can install what asks for it
roslab_out_of_reach() { # PYTHON NAME
  local bound newest wanted_by
  bound="$(sed -n "s/.*No matching distribution found for $2[^ ;(]*>=\{0,1\}\([0-9][0-9.]*\).*/\1/p" "${log}" | tail -n 1)"
  newest="$(sed -n "s/.*requirement $2[^A-Za-z0-9._-].*(from versions: \(.*\)).*/\1/p; s/.*Ignored the following .*versions[^:]*: \(.*\)/\1/p" "${log}" \
    | sed 's/[,;]/\n/g' | sed 's/^ *//; s/ .*//' | { grep '^[0-9]' || true; } | sort -V | tail -n 1)"
  if [ -z "${bound}" ] || [ -z "${newest}" ] || [ "$(printf '%s\n' "${bound}" "${newest}" | sort -V | tail -n 1)" = "${newest}" ]; then
    return 1
  fi
  wanted_by="$(sed -n "s/.*requirement $2[^A-Za-z0-9._-][^(]*(from \([A-Za-z0-9._-]*\).*(from versions: .*/\1/p" "${log}" | tail -n 1)"
  if [[ "${wanted_by}" =~ ^[A-Za-z0-9] ]]; then roslab_apart "$1" "${wanted_by}" || return 1; fi
  roslab_reword "s/^\([[:space:]]*$2\([[:space:]]*\[[^]]*\]\)\{0,1\}\)[[:space:]]*(\{0,1\}[<>=!~][^;#]*/\1 /" || return 1
  echo "roslab: no release of $2 reaches ${bound}, its newest is ${newest}: the bound is left out" >&2
}
# Installs the one project of a call by itself, and has the call install what it asks for, as a list
roslab_apart() { # PYTHON NAME
  local at project='' extras='' rest=()
  for at in "${!call[@]}"; do
    case "${call[at]}" in
      -e | --editable) continue ;;
      [./]*) ;;
      *) rest+=("${call[at]}") && continue ;;
    esac
    case "${call[at - 1]}" in
      -e | --editable | [!-]*) if [ -n "${project}" ]; then return 1; fi ;;
      --no-*) ;;
      *) rest+=("${call[at]}") && continue ;; # of an option
    esac
    project="${call[at]}"
  done
  if [ -z "${project}" ]; then return 1; fi
  if [ "${project}" != "${project%]}" ]; then extras="${project##*[}"; fi
  command "${call[@]}" --no-deps || return 1
  roslab_asked "$1" "$2" "${extras%]}" >"${notes}.asked" || return 1
  call=("${rest[@]}" --requirement "${notes}.asked")
}
# Prints what an installed package asks for on this Python, each a line
roslab_asked() { # PYTHON NAME EXTRAS
  command "$1" - "$2" "$3" <<'PYTHON'
import sys

name, extras = sys.argv[1], [extra.strip() for extra in sys.argv[2].split(",")]
try:
    from importlib.metadata import requires

    from pip._vendor.packaging.requirements import Requirement

    found = [Requirement(line) for line in requires(name) or ()]
    found = [each for each in found if not each.marker or any(each.marker.evaluate({"extra": e}) for e in extras)]
except ImportError:  # before Python 3.8
    from pip._vendor.pkg_resources import get_distribution

    found = get_distribution(name).requires(tuple(filter(None, extras)))
for each in found:
    each.marker = None
    print(each)
PYTHON
}
# Changes the requirements of the call and of its files; tells whether there was something to change
roslab_reword() { # SED'S EXPRESSION
  local at word changed=''
  for at in "${!call[@]}"; do
    case "${call[at - (at > 0)]}" in
      -r | --requirement)
        if sed "$1" "${call[at]}" 2>/dev/null | cmp --quiet - "${call[at]}"; then continue; fi
        sed -i "$1" "${call[at]}" || return 1
        ;;
      *)
        # shellcheck disable=SC2001 # the expression is one of sed
        word="$(sed "$1" <<<"${call[at]}")"
        if [ "${word}" = "${call[at]}" ]; then continue; fi
        call[at]="${word}"
        ;;
    esac
    changed=yes
  done
  [ -n "${changed}" ]
}
# Replaces an exact version that the index no longer has, in the call and in its requirement files
roslab_next_version() {
  local asked minor next
  asked="$(sed -n "s/.*No matching distribution found for $1==\([0-9][0-9.]*[0-9]\)\([^0-9.].*\)\{0,1\}$/\1/p" "${log}" | tail -n 1)"
  minor="$(cut -d . -f 1,2 <<<"${asked}")"
  next="$(sed -n "s/.*requirement $1==${asked}[ ;].*(from versions: \(.*\)).*/\1/p" "${log}" | tail -n 1 | tr -d ' ' | tr , '\n' \
    | { grep -E "^${minor}([.][0-9]+)+$" || true; } | { cat && echo "${asked}"; } | sort -V | sed "1,/^${asked}$/d" | head -n 1)"
  if [ -z "${asked}" ] || [ -z "${next}" ]; then return 1; fi
  roslab_reword "s/^\([[:space:]]*$1[[:space:]]*==[[:space:]]*\)${asked}\([^0-9.]\|$\)/\1${next}\2/" || return 1
  echo "roslab: the index no longer has $1 ${asked}: ${next} is taken" >&2
}
python3() { roslab_pip python3 "$@"; }
python2() { roslab_pip python2 "$@"; }
