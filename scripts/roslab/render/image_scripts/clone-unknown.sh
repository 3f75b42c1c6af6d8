#!/bin/bash
# usage: clone-unknown [--before DAY] [--want PACKAGES] MANIFESTS WORKSPACE KEY...
# Clones to the workspace the packages of these keys that the repository, whose package.xml files lie below MANIFESTS, and
# the cloned repositories which it needs ask for: from lists that these carry (.rosinstall, .repos, treep's), by the name there, else
# by what the listed repositories hold. What a clone asks for is then looked for with its owner, by the name of the package,
# or of what it is a part of (X for X_msgs, X_Y for X_Y_Z); and what the repository asks for and a repository of lists alone
# does not name, with the owner of that. Each key is tried once. Ends with 1 where nothing was found.
#   --before DAY     the newest commit not after this day (YYYY-MM-DD), unless a list names a tag or commit; of today if empty
#   --want PACKAGES  what the repository asks for beside its package.xml files, separated by spaces
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

day=() want=()
while [[ "$1" = --* ]]; do
  if [ "$1" = --want ]; then read -r -a want <<<"$2"; elif [ -n "$2" ]; then day=(--before "$2"); fi
  shift 2
done
manifests="$1" workspace="$2" tried=/tmp/clone-unknown
shift 2
beside=() # a repository that only lists clones has its manifests in the workspace alone
if [ ! "${manifests}" -ef "${workspace}" ]; then beside=(--beside "${manifests}"); fi
touch "${tried}" "${tried}.looked" "${tried}.held"
export GIT_TERMINAL_PROMPT=0 # where a host has no such repository it asks for a password, which nobody is there to give

mapfile -t own < <(find "${manifests}" -name package.xml -exec read-manifest depends {} +)
own+=("${want[@]}")
declare -A asked=() wanted=()
for name in "${own[@]}"; do wanted["${name}"]=yes; done
while IFS=$'\t' read -r _ manifest; do
  while read -r name; do
    asked["${name}"]="${asked["${name}"]:-${manifest}}" # the first clone that asks
  done < <(read-manifest depends "${manifest}")
done < <(workspace-packages needed "${workspace}" "${own[@]}")

listed() { listed-repositories "${workspace}" 2 4; }

# Clones to the folder `bare` no more of a repository than manifests ask for, where the host and git can: all commits
# where a day is given. Where git filters nothing, as that of Ubuntu 16.04, that is only done for owners of clones
look_into() { # URL REF
  local url="$1" at=(--quiet --bare --single-branch)
  if [ -n "$2" ]; then at+=(--branch "$2"); fi
  if [ "${#day[@]}" -eq 0 ]; then at+=(--depth 1); fi
  rm -rf "${bare}" # of a look that was interrupted: git clones into no folder that is there
  if git clone "${at[@]}" --filter=blob:none "${url}" "${bare}" 2>/dev/null; then return; fi
  if [ "${#day[@]}" -gt 0 ] && grep --quiet --no-messages --fixed-strings "url = ${url%/*}/" "${workspace}"/*/.git/config &&
    git clone "${at[@]}" "${url}" "${bare}" 2>/dev/null; then return; fi
  git clone --quiet --bare --depth 1 "${url}" "${bare}" 2>/dev/null # a commit is no branch
}

# Prints NAME URL REF of what the listed repositories hold, of a branch as of the day. Looks once into each
held() {
  local url ref name bare="${tried}.git" manifest="${tried}.xml" path package commit
  while read -r name url ref; do
    if grep --quiet --line-regexp --fixed-strings "${url} ${ref}" "${tried}.looked"; then continue; fi
    echo "${url} ${ref}" >>"${tried}.looked"
    if [ -e "${workspace}/$(basename "${url}" .git)" ] || ! look_into "${url}" "${ref}"; then continue; fi
    commit=''
    if [ "${#day[@]}" -gt 0 ] && git -C "${bare}" symbolic-ref --quiet HEAD >/dev/null; then # a tag is no branch
      commit="$(git -C "${bare}" rev-list --max-count=1 --first-parent --before="${day[1]}T23:59:59Z" HEAD)"
    fi
    commit="${commit:-HEAD}"
    while read -r path; do
      git -C "${bare}" show "${commit}:${path}" >"${manifest}"
      package="$(read-manifest name "${manifest}")"
      if [ -n "${package}" ]; then echo "${package} ${url} ${ref}" >>"${tried}.held"; fi
    done < <(git -C "${bare}" -c core.quotePath=false ls-tree -r --name-only "${commit}" | grep --extended-regexp '(^|/)package\.xml$')
    rm -rf "${bare}" "${manifest}"
  done < <(listed)
  cat "${tried}.held"
}

# Prints a list of a repository that holds lists and no packages, which somebody cloned for them
lists_alone() {
  local list
  while read -r list; do
    if [ -z "$(find "$(dirname "${list}")" -name package.xml -print -quit)" ]; then
      echo "${list}"
      return
    fi
  done < <(find "${workspace}" -mindepth 2 -maxdepth 2 \( -name '*.rosinstall' -o -name '*.repos' -o -path '*/treep_*/repositories*.yaml' \) | sort)
}

folder=''
try() { # PACKAGE URL [REF]
  local url="$2" at=("${day[@]}") # git in the image takes the public hosts by https
  if [ -n "${3:-}" ]; then at+=(--ref "$3"); fi
  folder="${workspace}/$(basename "${url}" .git)"
  if [ -e "${folder}" ]; then return 1; fi
  clone-holding "${at[@]}" "${url}" "${folder}" "$1"
  if [ ! -e "${folder}" ]; then return 1; fi
  # What it needs in turn may be there already: rosdep finds nothing where two packages have one name
  (cd "$(dirname "${workspace}")" && leave-out-doubles "${beside[@]}" "${folder#"$(dirname "${workspace}")/"}")
  chown --recursive --reference="${workspace}" "${folder}"
}

new=''
for key in "$@"; do
  # What is named so is a package of the system or of pip, and none of ROS
  if [[ ! "${key}" =~ ^[a-z][a-z0-9_-]*$ || "${key}" =~ ^(python|ros-)|-(dev|pip)$ ]]; then continue; fi
  manifest="${asked["${key}"]:-}"
  if [ -z "${manifest}${wanted["${key}"]:-}" ] || grep --quiet --line-regexp --fixed-strings "${key}" "${tried}"; then continue; fi
  echo "${key}" >>"${tried}"
  if [ -n "$(workspace-packages needed "${workspace}" "${key}")" ]; then continue; fi
  if [ -n "$(workspace-packages show "${workspace}" "${key}")" ]; then # a clone of before has it
    echo "roslab: no longer hidden: ${key}"
    new=yes
    continue
  fi
  for tell in listed held; do
    while read -r name url ref; do
      if [ "${name}" = "${key}" ] && try "${key}" "${url}" "${ref}"; then
        new=yes
        continue 3
      fi
    done < <("${tell}")
  done
  if [ -z "${manifest}" ]; then # the plan has it looked for with the owner of the repository, unless lists stand for that
    manifest="$(lists_alone)"
    if [ -z "${manifest}" ]; then continue; fi
  fi
  # What is called like a library of the system is a package where the code includes headers of a folder of its name, or
  # where it ends as packages of ROS do
  headers="^ *# *include *[<\"]${key}/"
  if [[ "${key}" = lib* && ! "${key}" =~ _(ros2?|msgs|srvs|interfaces)$ ]] && ! grep --quiet --recursive --exclude-dir=.git "${headers}" "$(dirname "${manifest}")"; then continue; fi
  origin="$(git -c safe.directory='*' -C "$(dirname "${manifest}")" config --get remote.origin.url)" || continue
  # A part is with the whole: in X for X_msgs, and in X_Y for X_Y_Z. Who writes names of repositories with dashes does so there
  for name in $(sed --regexp-extended 'p; s/_(msgs|srvs|interfaces|lib)$//; p; :a; s/^([^_]+_.+)_[^_]*$/\1/; p; ta; d' <<<"${key}" | uniq); do
    spelled="${name}"
    if [[ "${origin##*/}" = *-* && "${origin##*/}" != *_* ]]; then spelled="${name//_/-}"; fi
    if try "${key}" "${origin%/*}/${spelled}" || { [ "${spelled}" != "${name}" ] && try "${key}" "${origin%/*}/${name}"; }; then
      new=yes
      break
    fi
  done
done
[ -n "${new}" ]
