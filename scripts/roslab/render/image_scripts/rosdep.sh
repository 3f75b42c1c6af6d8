#!/bin/bash
# Stands before the rosdep of a distribution that has ended. `update` takes the tables of the tag in
# ROSDISTRO_INDEX_URL, whatever list `rosdep init` wrote, and does not skip the distribution.
set -euo pipefail

program=/usr/bin/rosdep
if [ "${1:-}" = update ]; then
  tables="${ROSDISTRO_INDEX_URL%/index-v4.yaml}"
  for list in /etc/ros/rosdep/sources.list.d/*.list; do
    if [ -w "${list}" ]; then
      sed --in-place --regexp-extended "s#https?://raw\.githubusercontent\.com/ros/rosdistro/(master|HEAD)#${tables}#" "${list}"
    fi
  done
  options="$("${program}" update --help)"
  case "${options} $*" in
    *' --rosdistro'*' --rosdistro'* | *--include-eol-distros*' --include-eol-distros'*) ;; # the author says it
    *--rosdistro*) set -- "$@" --rosdistro "${ROS_DISTRO}" ;;
    *--include-eol-distros*) set -- "$@" --include-eol-distros ;;
  esac
fi
exec "${program}" "$@"
