#!/bin/bash
# usage: configure-library [OPTION...] FOLDER
# Configures a library of which nothing could be read when the image was planned, in the current folder.
# Where CMake fails, it is configured once more without what its own options leave out and nothing links: bindings for
# other languages, tests, examples, benchmarks, documentation. Options that are given stay as they are.
set -euo pipefail

part='(.*_)?(PYTHON[0-9]*|MATLAB|OCTAVE|JAVA|(PY)?BINDINGS?|TEST(S|ING)?|EXAMPLES?|DEMOS?|SAMPLES?|TUTORIALS?'
part+='|BENCHMARKS?|DOCS?|DOCUMENTATION|DOXYGEN)(_.*)?'

status=0
cmake "$@" || status=$?
if [ "${status}" -eq 0 ]; then exit; fi
given="$(printf '%s\n' "$@" | sed --quiet --regexp-extended 's/^-D([^:=]+).*/\1/p')"
without=()
# CMake writes down each option that it came to, also where it fails
while IFS='' read -r name; do
  if [[ "${name}" =~ ^(.*_)?(NO|NOT|WITHOUT|DISABLE|SKIP)_ ]]; then continue; fi
  if grep --quiet --line-regexp --fixed-strings --regexp="${name}" <<<"${given}"; then continue; fi
  without+=("-D${name}=OFF")
done < <(sed --quiet --regexp-extended "s/^(${part}):BOOL=(ON|1|TRUE|YES|Y)\$/\1/Ip" CMakeCache.txt)
if [ "${#without[@]}" -eq 0 ]; then exit "${status}"; fi
echo "roslab: what the library does not need is left out, ${without[*]}: once more"
rm -rf CMakeCache.txt CMakeFiles
cmake "${without[@]}" "$@"
