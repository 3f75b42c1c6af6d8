#!/bin/bash
# usage: eval "$(git-as-of DAY)"
# Comes before git itself in PATH for the rest of this step, under its name. It is git, but brings each clone, and each
# branch of its remote, to the last commit of a day (UTC): pip and CMake fetch repositories and know no days. CMake
# fetches once more after each clone, and goes to where the remote's branch then is.
# A tag or a commit that they are told to take is checked out afterwards, as ever.
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

PATH="${PATH//"${0%/*}:"/}"
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
if [ -z "${GIT_AS_OF:-}" ] || [[ "${command}" != clone && "${command}" != fetch ]]; then
  exec git "$@"
fi
git "$@"

# The last commit of the day that was on a branch; where only the newest ones were fetched, with the others
of_day() {
  local commit
  commit="$("${here[@]}" rev-list -1 --first-parent --before="${GIT_AS_OF}T23:59:59Z" "$1")"
  if [ -z "${commit}" ] && [ -e "$("${here[@]}" rev-parse --show-toplevel)/.git/shallow" ]; then
    "${here[@]}" fetch --quiet --unshallow >&2
    commit="$("${here[@]}" rev-list -1 --first-parent --before="${GIT_AS_OF}T23:59:59Z" "$1")"
  fi
  echo "${commit}"
}

if [ "${command}" = clone ]; then
  folder="${!#}"
  inside=("${here[@]}" -C)
  if [ "$("${inside[@]}" "${folder}" rev-parse --git-dir 2>/dev/null)" != .git ]; then # git names it by the address
    folder="${folder%/}"
    folder="${folder##*[/:]}"
    folder="${folder%.git}"
  fi
  here=("${inside[@]}" "${folder}")
  # A tag that is asked for has no branch; a mirror has nothing checked out
  if [ "$("${here[@]}" rev-parse --is-inside-work-tree 2>/dev/null)" = true ] \
    && "${here[@]}" symbolic-ref --quiet HEAD >/dev/null; then
    commit="$(of_day HEAD)"
    if [ -n "${commit}" ]; then
      "${here[@]}" reset --quiet --hard "${commit}"
      if [[ " $* " == *" --recurs"* ]]; then
        "${here[@]}" submodule --quiet update --init --recursive
      fi
    else
      echo "roslab: ${folder##*/} has no commit of ${GIT_AS_OF} or before: its newest one is taken" >&2
    fi
  fi
fi
if ! "${here[@]}" rev-parse --git-dir >/dev/null 2>&1; then exit 0; fi
"${here[@]}" for-each-ref --format='%(refname)' refs/remotes | while read -r branch; do
  if [[ "${branch}" != */HEAD ]]; then
    commit="$(of_day "${branch}")"
    if [ -n "${commit}" ]; then "${here[@]}" update-ref "${branch}" "${commit}"; fi
  fi
done
