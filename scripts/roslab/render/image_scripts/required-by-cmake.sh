#!/bin/bash
# usage: required-by-cmake FILE...
# Prints the names of what CMakeLists.txt files require as packages of ROS are: components of catkin, and packages alone.
set -eu # a search that finds nothing is no failure

for file in "$@"; do
  code="$(sed 's/#.*//' "${file}" | tr '\n' ' ')"
  grep --only-matching --ignore-case --extended-regexp 'find_package *\( *catkin [^)]*' <<<"${code}" |
    sed --quiet --regexp-extended 's/.*COMPONENTS//p' | tr -s ' \t' '\n'
  grep --only-matching --ignore-case --extended-regexp 'find_package *\( *[a-z][a-z0-9_]* +REQUIRED *\)' <<<"${code}" |
    sed --regexp-extended 's/.*\( *([a-z0-9_]+).*/\1/'
done | grep --line-regexp --extended-regexp '[a-z][a-z0-9_]*' | grep --line-regexp --invert-match catkin | sort --unique
