#!/bin/bash
# usage: take-listed [--branch BRANCH] [--before DAY] [--but NAME] URL FOLDER
# Clones to a folder of the workspace what the repository of a workspace, to which a page sends its reader, or one that a list
# of gitman has installed with its own list, names: in .rosinstall, .repos and gitman's files, else by its submodules. It is taken in place of what lies in the workspace under the same
# name, which only a table or another page names. What cannot be cloned is told, and what lies there stays.
#   --branch BRANCH  or a commit, of that repository; by default one of the ROS distribution's, if there is one
#   --before DAY     the newest commit not after this day (YYYY-MM-DD), but where the list names a tag or commit
#   --but NAME       the repository that is built itself
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

branch='' day='' but=''
while [[ "$1" = --* ]]; do
  case "$1" in
    --branch) branch="$2" ;;
    --before) day="$2" ;;
    --but) but="$2" ;;
  esac
  shift 2
done
url="$1" folder="$2" workspace="$(dirname "$2")" most=40
export GIT_TERMINAL_PROMPT=0 # where a host has no such repository it asks for a password, which nobody is there to give

if ! git clone "${url}" "${folder}"; then
  echo "roslab: left out: ${url} cannot be cloned, and what it lists is not known"
  rm -rf "${folder}"
  exit 0
fi
if [ -z "${branch}" ]; then
  for own in "${ROS_DISTRO}-devel" "${ROS_DISTRO}"; do
    if git -C "${folder}" rev-parse --quiet --verify "origin/${own}" >/dev/null; then branch="${branch:-${own}}"; fi
  done
fi
if [ -n "${branch}" ]; then checkout-branch "${folder}" "${branch}"; fi
of_day() { # FOLDER
  if [ -z "${day}" ]; then return; fi
  local commit
  commit="$(git -C "$1" rev-list --max-count=1 --first-parent --before="${day}T23:59:59Z" HEAD)"
  git -C "$1" -c advice.detachedHead=false checkout --quiet "${commit:-HEAD}" --
}
of_day "${folder}"

# Prints NAME URL REF of what the lists and submodules of the repository name
listed() {
  listed-repositories "${folder}" 1 3 || true
  if [ -f "${folder}/.gitmodules" ]; then
    git config --file "${folder}/.gitmodules" --get-regexp '^submodule\..*\.path$' | while read -r key path; do
      echo "$(basename "${path}") $(git config --file "${folder}/.gitmodules" "${key%.path}.url")" \
        "$(git -C "${folder}" rev-parse --quiet --verify "HEAD:${path}" || true)"
    done
  fi
}

taken=' '
while read -r name from ref; do
  place="${folder}/${name}" there="${workspace}/${name}"
  if [[ ! "${name}" =~ ^[A-Za-z0-9_][A-Za-z0-9_.-]*$ || "${from}" = -* || "${taken}" = *" ${name} "* || "${name}" = "${but}" ]]; then continue; fi
  if [ "$(basename "${from}" .git)" = "${but}" ] || [ "${most}" -eq 0 ]; then continue; fi
  taken+="${name} " most=$((most - 1))
  if [[ "${from}" != *:* ]]; then from="${url%/*}/${from##*/}"; fi # a submodule's address may be relative
  rm -rf "${place}"
  if ! git clone "${from}" "${place}" || { [ -n "${ref}" ] && ! git -C "${place}" -c advice.detachedHead=false checkout "${ref}" --; }; then
    echo "roslab: left out: ${from} ${ref}, which ${url} lists, cannot be cloned"
    rm -rf "${place}"
    continue
  fi
  if [ -z "${ref}" ] || git -C "${place}" rev-parse --quiet --verify "refs/remotes/origin/${ref}" >/dev/null; then of_day "${place}"; fi
  fetch-submodules "${place}"
  if [ -e "${there}/.git" ] && [ "${there}" != "${folder}" ]; then
    echo "roslab: ${name} is taken as ${url} lists it"
    # install-plain-clones, and who leaves out what fails, know it by that folder
    if [ -e "${there}/.git/roslab-plain" ]; then cp "${there}/.git/roslab-plain" "${place}/.git"; fi
    rm -rf "${there}"
    mv "${place}" "${there}"
  fi
done < <(listed)
