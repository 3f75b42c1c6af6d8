#!/bin/bash
# usage: checkout-branch FOLDER BRANCH
# Checks a branch out. Where it was renamed or removed, that of the ROS distribution is taken, else the default branch
# stays, and that is said; of master and main, which are names of one branch, the other one comes before.
set -euo pipefail

folder="$1" branch="$2"
there() { git -C "${folder}" -c advice.detachedHead=false checkout --quiet "$1" -- 2>/dev/null; }

if there "${branch}"; then exit 0; fi
case "${branch}" in
  master) if there main; then exit 0; fi ;;
  main) if there master; then exit 0; fi ;;
esac
for other in ${ROS_DISTRO:+"${ROS_DISTRO}-devel" "${ROS_DISTRO}"}; do
  if there "${other}"; then break; fi
done
took="$(git -C "${folder}" rev-parse --abbrev-ref HEAD)"
echo "roslab: left out: $(git -C "${folder}" config --get remote.origin.url) has no ${branch} any more: ${took} is taken"
