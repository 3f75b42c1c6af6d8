#!/bin/bash
# usage: warnings-pass FOLDER COMMAND...
# Runs a command that compiles what is in a folder. Where it stops at a warning that counts as an error, it is run once more
# with warnings that stop nothing: the compiler and the libraries of the image warn of more than the author's did.
set -euo pipefail

folder="$1" code=0
shift
said="$(mktemp)"
trap 'rm -f "${said}"' EXIT # no layer keeps its name, which is another each time
"$@" 2>&1 | tee "${said}" || code="${PIPESTATUS[0]}"
if [ "${code}" = 0 ]; then exit 0; fi
if ! grep --quiet --extended-regexp '\[-Werror|(all|some) warnings being treated as errors' "${said}"; then exit "${code}"; fi

strict='(^|[^[:alnum:]_-])-Werror\b|\b(CMAKE_)?COMPILE_WARNING_AS_ERROR[[:space:]]+(ON|TRUE|1|YES)\b'
mapfile -t files < <(grep --recursive --files-with-matches --extended-regexp --ignore-case --exclude-dir=.git \
  --include=CMakeLists.txt --include='*.cmake' --include=Makefile --include=makefile --include=GNUmakefile --include='*.mk' \
  "${strict}" "${folder}" | LC_ALL=C sort)
if [ "${#files[@]}" -eq 0 ]; then exit "${code}"; fi
# In the place of an option, not away: CMake may count the words of a call
sed --in-place --regexp-extended \
  --expression 's/(^|[^[:alnum:]_-])-Werror\b/\1-Wno-error/g' \
  --expression 's/\b((CMAKE_)?COMPILE_WARNING_AS_ERROR[[:space:]]+)(ON|TRUE|1|YES)\b/\1OFF/Ig' "${files[@]}"
echo 'roslab: the compiler stops at a warning that counts as an error: once more with warnings that stop nothing, in'
printf 'roslab:   %s\n' "${files[@]}"
"$@"
