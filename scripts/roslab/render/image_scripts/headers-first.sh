#!/bin/bash
# usage: headers-first COMMAND...
# Compiles a workspace of catkin in the current folder. Much code of ROS 1 includes what is generated from messages or
# parameters without waiting for it, and compiles by chance, as the order of the targets has it. Where such a header was
# not there yet, all of them are generated first: by catkin_make of the workspace, by other tools of the package whose
# header it is, and once for each package.
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

generated() {
  make --directory="$1" help 2>/dev/null | sed --quiet --regexp-extended 's/^\.\.\. (.*_(generate_messages|gencfg))$/\1/p'
}

said="$(mktemp)"
tried=' '
until "$@" 2>&1 | tee "${said}"; do
  header="$(sed --quiet '\#.*fatal error: \([A-Za-z0-9_]*/[A-Za-z0-9_]*\.h\): No such file.*# { s##\1#p; q }' "${said}")"
  package="${header%%/*}"
  case "$1" in
    catkin_make) folder=build ;;
    catkin_make_isolated) folder="build_isolated/${package}" ;;
    catkin) folder="build/${package}" ;;
    *) exit 1 ;;
  esac
  if [ -z "${header}" ] || [[ "${tried}" = *" ${package} "* ]]; then exit 1; fi
  mapfile -t targets < <(generated "${folder}")
  if [[ ! " ${targets[*]}" =~ \ "${package}"_(generate_messages|gencfg) ]]; then exit 1; fi
  tried+="${package} "
  echo "roslab: what includes ${header} does not wait until it is generated: once more, with all that is generated first"
  make --directory="${folder}" --jobs="$(nproc)" "${targets[@]}"
done
rm "${said}"
