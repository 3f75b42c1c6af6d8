#!/bin/bash
# usage: eval "$(git-as-of DAY)"
# Comes before git itself in PATH for the rest of this step, under its name. It is git, but brings each clone, what it
# pulls, FETCH_HEAD, and each branch of its remote, to the last commit of a day (UTC): pip, CMake and scripts fetch
# repositories and know no days. CMake fetches once more after each clone, and goes to where the remote's branch then is.
# A tag or a commit that they are told to take is checked out afterwards, as ever; master is main where a host renamed it.
set -euo pipefail

# CMake writes down where git was, and is called again in later steps: there it is git, and nothing else. Else the name
# alone is there: nothing can be executed in that folder, which no layer keeps
before=/usr/local/lib/git-as-of
if [[ "${1:-}" = [0-9]* ]]; then # as no command of git begins
  if [ ! -e "${before}/git" ]; then
    before=/dev/shm/as-of
    mkdir -p "${before}"
    ln -sf "$(command -v git-as-of)" "${before}/git"
  fi
  echo "export GIT_AS_OF=$1 PATH=\"${before}:\${PATH}\""
  exit 0
fi

path=":${PATH}:"
path="${path//":${0%/*}:"/:}"
path="${path#:}"
PATH="${path%:}"
# Options before the command, with which its repository is found
here=(git)
command=''
words=("$@")
for ((i = 0; i < $#; i++)); do
  case "${words[i]}" in
    -C | -c | --git-dir | --work-tree | --namespace | --exec-path | --config-env)
      here+=("${words[i]}" "${words[i + 1]:-}")
      i=$((i + 1))
      ;;
    -*) here+=("${words[i]}") ;;
    *)
      command="${words[i]}"
      break
      ;;
  esac
done
if [ -z "${GIT_AS_OF:-}" ] || [[ ! "${command}" =~ ^(clone|fetch|pull)$ ]]; then
  exec git "$@"
fi
# master and main are names of one branch, which hosts renamed after many files had been written: where git fails for one
# of them, it is asked for the other
renamed=()
asked=''
last=''
for word in "$@"; do
  other="${word}"
  case "${word}" in
    master | -bmaster | --branch=master) other="${word%master}main" ;;
    main | -bmain | --branch=main) other="${word%main}master" ;;
  esac
  # A clone's folder may be called so, too
  if [ "${command}" = clone ] && [[ "${word}" != -* && ! "${last}" =~ ^(-b|--branch)$ ]]; then other="${word}"; fi
  if [ "${other}" != "${word}" ]; then asked="${word##*[b=]}"; fi
  renamed+=("${other}")
  last="${word}"
done
status=0
git "$@" || status=$?
if [ "${status}" != 0 ]; then
  if [ -z "${asked}" ] || ! git "${renamed[@]}"; then exit "${status}"; fi
  echo "roslab: taken in its place: git ${renamed[*]}" >&2
fi

# The last commit of the day that was on a branch
of_day() { # BRANCH
  "${here[@]}" rev-list -1 --first-parent --before="${GIT_AS_OF}T23:59:59Z" "$1"
}
# Where only the newest commits were fetched and none is of the day, the others are fetched, too
deepened=''
deepen() { # BRANCH
  if [ -z "${deepened}" ] && [ -e "$("${here[@]}" rev-parse --show-toplevel)/.git/shallow" ] && [ -z "$(of_day "$1")" ]; then
    deepened=yes
    "${here[@]}" fetch --quiet --unshallow >&2 || true
  fi
}
# A later checkout finds a remote's branch by either name
both_names() {
  local branch other
  while read -r branch; do
    case "${branch##*/}" in
      main) other="${branch%main}master" ;;
      *) other="${branch%master}main" ;;
    esac
    if ! "${here[@]}" show-ref --verify --quiet "${other}"; then "${here[@]}" update-ref "${other}" "${branch}"; fi
  done < <("${here[@]}" for-each-ref --format='%(refname)' 'refs/remotes/*/main' 'refs/remotes/*/master')
}

if [ "${command}" = clone ]; then
  # What stands behind the options: the address, and the folder or none
  said=()
  for ((i = i + 1; i < $#; i++)); do
    case "${words[i]}" in
      -b | --branch | -o | --origin | -u | --upload-pack | -c | --config | -j | --jobs | --depth | --filter | --template) i=$((i + 1)) ;;
      --reference | --reference-if-able | --separate-git-dir | --server-option | --shallow-since | --shallow-exclude) i=$((i + 1)) ;;
      -*) ;;
      *) said+=("${words[i]}") ;;
    esac
  done
  folder="${said[1]:-}"
  if [ -z "${folder}" ]; then # git names it by the address
    folder="${said[0]%/}"
    folder="${folder%/.git}"
    folder="${folder##*[/:]}"
    folder="${folder%.git}"
  fi
  here+=(-C "${folder}")
  # A mirror has nothing checked out
  if [ "$("${here[@]}" rev-parse --is-inside-work-tree 2>/dev/null)" != true ]; then exit 0; fi
  # A tag that was asked for has no branch, and nothing more is asked of its clone
  if ! "${here[@]}" symbolic-ref --quiet HEAD >/dev/null; then exit 0; fi
  both_names
  deepen HEAD
  commit="$(of_day HEAD)"
  if [ -n "${commit}" ]; then
    "${here[@]}" reset --quiet --hard "${commit}"
    if [[ " $* " == *" --recurs"* ]]; then
      "${here[@]}" submodule --quiet sync --recursive
      "${here[@]}" submodule --quiet update --init --recursive \
        || echo "roslab: left out: submodules of ${folder##*/} as it was on ${GIT_AS_OF}" >&2
    fi
  else
    echo "roslab: ${folder##*/} has no commit of ${GIT_AS_OF} or before: its newest one is taken" >&2
  fi
  # A clone of one branch knows no other one's name
  if [ "${status}" != 0 ]; then "${here[@]}" branch --quiet --no-track "${asked}" HEAD; fi
fi
if ! "${here[@]}" rev-parse --git-dir >/dev/null 2>&1; then exit 0; fi
if [ "${command}" = fetch ]; then both_names; fi
fetched="$("${here[@]}" rev-parse --absolute-git-dir)/FETCH_HEAD"
heads="$(cat "${fetched}" 2>/dev/null || true)" # to deepen writes it anew
if [ "${command}" = pull ]; then
  deepen HEAD
  commit="$(of_day HEAD)"
  # --keep: what the step changed there stays
  if [ -n "${commit}" ]; then "${here[@]}" reset --quiet --keep "${commit}"; fi
fi
while read -r branch; do
  if [[ "${branch}" != */HEAD ]]; then
    deepen "${branch}"
    commit="$(of_day "${branch}")"
    if [ -n "${commit}" ]; then "${here[@]}" update-ref "${branch}" "${commit}"; fi
  fi
done < <("${here[@]}" for-each-ref --format='%(refname)' refs/remotes)
if [ -z "${heads}" ]; then exit 0; fi
while IFS= read -r line; do
  commit="${line%%$'\t'*}"
  if [[ "${line}" = *$'\t'"branch '"* ]]; then
    deepen "${commit}"
    commit="$(of_day "${commit}")"
  fi
  printf '%s\t%s\n' "${commit:-${line%%$'\t'*}}" "${line#*$'\t'}"
done <<<"${heads}" >"${fetched}.of-day"
mv "${fetched}.of-day" "${fetched}"
