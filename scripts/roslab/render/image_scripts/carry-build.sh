#!/bin/bash
# usage: carry-build take | carry-build size FOLDER | carry-build pack FOLDER
# Moves what a build compiled between a cache mount, which one builder has, and an image, which travels: the build tree of a ROS
# workspace, and what ccache keeps.
# take: out of /before/tree.tar into a mount that has neither. size: write the bytes of what is in the mount to FOLDER/size, or
# "none" if nothing is, or "same" if it is what was taken or packed last. pack: write it to FOLDER/tree.tar.
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

cd /var/cache/roslab-build
parts=()
if [ -e fingerprint ]; then parts=(contents fingerprint tree); fi # a build that failed leaves a tree without one, which none takes
if [ -e ccache ]; then parts+=(ccache); fi
# What the mount's state is known by: without a tree, the names of what ccache keeps, which say what they were made of
state() {
  if [ -e fingerprint ]; then cat fingerprint contents; else find ccache -type f -not -name stats | sort; fi | sha256sum
}

case "$1" in
  take)
    if [ "${#parts[@]}" -eq 0 ] && [ -e /before/tree.tar ]; then
      rm -rf tree
      tar --extract --same-owner --file=/before/tree.tar
      state >carried
    fi
    ;;
  size)
    mkdir --parents "$2"
    if [ "${#parts[@]}" -eq 0 ]; then
      echo none
    elif [ -e carried ] && [ "$(cat carried)" = "$(state)" ]; then
      echo same
    else
      du --summarize --bytes --total "${parts[@]}" | tail --lines=1 | cut --fields=1
    fi >"$2/size"
    ;;
  pack)
    mkdir --parents "$2"
    if [ "${#parts[@]}" -gt 0 ]; then
      state >carried
      tar --create --sort=name --file="$2/tree.tar" "${parts[@]}"
    fi
    ;;
esac
