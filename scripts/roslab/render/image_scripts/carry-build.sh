#!/bin/bash
# usage: carry-build take | carry-build size FOLDER | carry-build pack FOLDER
# Moves the build tree of a ROS workspace between a cache mount, which one builder has, and an image, which travels.
# take: out of /before/tree.tar into a mount that has none. size: write the bytes of the mount's tree to FOLDER/size, or
# "none" if there is none, or "same" if it is the one that was taken or packed last. pack: write it to FOLDER/tree.tar.
set -euo pipefail

cd /var/cache/roslab-build
state() { cat fingerprint contents | sha256sum; }

case "$1" in
  take)
    if [ ! -e tree ] && [ -e /before/tree.tar ]; then
      tar --extract --same-owner --file=/before/tree.tar
      state >carried
    fi
    ;;
  size)
    mkdir --parents "$2"
    if [ ! -e tree ]; then
      echo none
    elif [ -e carried ] && [ "$(cat carried)" = "$(state)" ]; then
      echo same
    else
      du --summarize --bytes tree | cut --fields=1
    fi >"$2/size"
    ;;
  pack)
    mkdir --parents "$2"
    if [ -e tree ]; then
      state >carried
      tar --create --sort=name --file="$2/tree.tar" contents fingerprint tree
    fi
    ;;
esac
