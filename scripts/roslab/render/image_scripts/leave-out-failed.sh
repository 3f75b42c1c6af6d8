#!/bin/bash
# usage: leave-out-failed [--keep PACKAGE]... [--most N --spare PATH...] [--own FOLDER] [FOLDER...] -- COMMAND...
# Runs a command that builds the workspace in the current folder. Where it fails in packages below one of these folders, it is
# run again without them, and they are told. The folders hold what is cloned, or packages that require what nothing brings:
# one that needs the SDK of a camera stops all others. The packages of --keep still stop the build. Of the packages at the
# paths of --spare, which nothing needs, so are at most N. Where hardly any package of the folder of --own would be left, the
# build stops: what they all lack is why.
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

kept=() cloned=() spare=() most=0 own='' lost=0
while [ "$1" != -- ]; do
  case "$1" in
    --keep) kept+=("$2") ;;
    --most) most="$2" ;;
    --own) own="$2" ;;
    --spare) spare+=("$2") ;;
    *)
      cloned+=("$1/")
      shift
      continue
      ;;
  esac
  shift 2
done
shift

# Prints the folders of the packages that a build tool says it failed in; catkin_make names only files below src
failed_in() {
  local name each
  sed --quiet --regexp-extended \
    -e "s:^(Failed +<<< |<== Failed to process package ')([A-Za-z0-9_-]+).*:\2:p" \
    -e 's:^.*\b(Errors|Failed) +<< ([A-Za-z0-9_-]+)\:.*:\2:p' "$1" | sort --unique | while read -r name; do
    workspace-packages needed src "${name}" | sed --quiet "s:^${name}\t\(.*\)/package[.]xml$:\1:p"
    for each in "${cloned[@]}"; do # what has no package.xml, colcon calls by the name of its project
      if [ -e "${each}package.xml" ] || [ ! -e "${each}CMakeLists.txt" ]; then continue; fi
      if grep --quiet --ignore-case --extended-regexp "^[[:space:]]*project[[:space:]]*\([[:space:]]*\"?${name}([[:space:])\"]|$)" "${each}CMakeLists.txt"; then
        echo "${each%/}"
      fi
    done
  done
  awk '/^CMake Error/ { error = 1 } /^CMake .*Warning/ { error = 0 }
    error && match($0, /[^ ]+[/]CMakeLists[.]txt:[0-9]+ [(]/) { print substr($0, RSTART, RLENGTH) }
    match($0, /[*][*][*] \[[^] :]+[/]CMakeFiles[/]/) { print substr($0, RSTART + 5, RLENGTH - 5) }' "$1" |
    sed --regexp-extended 's:/(CMakeLists[.]txt|CMakeFiles/).*::' | sort --unique | while read -r name; do
      name="src/${name}"
      while [ "${name}" != src ] && [ ! -e "${name}/package.xml" ]; do name="$(dirname "${name}")"; done
      if [ "${name}" != src ]; then echo "${name}"; fi
    done
}
# Tells whether a package may be left out, and counts those that are spare
may_go() {
  local each
  for each in "${cloned[@]}"; do
    if [[ "$1/" = "${each}"* ]]; then return; fi
  done
  for each in "${spare[@]}"; do
    if [ "$1" = "${each}" ] && [ "${most}" -gt 0 ]; then
      most=$((most - 1))
      return
    fi
  done
  return 1
}

# Prints how many packages a build tool finds below a folder: not those inside another, nor those that a marker hides
packages_below() {
  find "$1" -name .git -prune -o -regextype posix-extended -regex '.*/(package[.]xml|(AMENT|CATKIN|COLCON)_IGNORE)' -printf '%f\t%h\n' |
    awk -F '\t' '$1 == "package.xml" { packages[$2] = 1; next }
      { hidden[$2] = 1 }
      END {
        for (folder in packages) {
          above = folder
          found = !(folder in hidden)
          while (sub("/[^/]*$", "", above)) if (above in packages || above in hidden) found = 0
          count += found
        }
        print count + 0
      }'
}

log="$(mktemp)"
until "$@" 2>&1 | tee "${log}"; do
  hidden=()
  while read -r folder; do
    name="${folder##*/}"
    if [ -e "${folder}/package.xml" ]; then name="$(read-manifest name "${folder}/package.xml")"; fi
    if [ -e "${folder}/CATKIN_IGNORE" ] || [[ " ${kept[*]} " = *" ${name} "* ]] || ! may_go "${folder}"; then continue; fi
    touch "${folder}/CATKIN_IGNORE" "${folder}/COLCON_IGNORE"
    hidden+=("${name}")
    if [ -n "${own}" ] && [[ "${folder}/" = "${own}/"* ]]; then lost=$((lost + 1)); fi
  done < <(failed_in "${log}")
  if [ "${#hidden[@]}" -eq 0 ]; then
    rm -f "${log}"
    exit 1
  fi
  if [ "${lost}" -gt 0 ] && [ $((lost * 10)) -gt $(((lost + $(packages_below "${own}")) * 9)) ]; then
    rm -f "${log}"
    echo "roslab: of the packages in ${own} hardly any builds; the last that failed: ${hidden[*]}"
    exit 1
  fi
  echo "roslab: the workspace does not build: once more without what failed"
  echo "roslab: left out: ${hidden[*]}"
done
rm -f "${log}"
