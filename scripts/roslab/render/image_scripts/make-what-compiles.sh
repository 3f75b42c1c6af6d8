#!/bin/bash
# usage: make-what-compiles ARGUMENT...
# Runs make in the current folder and goes on where one of many programs does not compile: those that do are there, and the
# others are told. It ends as make did where no program was made.
set -euo pipefail

code=0
said="$(mktemp)" before="$(mktemp)"
trap 'rm -f "${said}" "${before}"' EXIT # no layer keeps their names, which are others each time
make --keep-going "$@" 2>&1 | tee "${said}" || code="${PIPESTATUS[0]}"
failed="$(sed --quiet --regexp-extended 's:^make.*[*]{3} \[([^]]* )?(.*/)?CMakeFiles/([^/]+)[.]dir/all\] Error.*:\3:p' \
  "${said}" | sort --unique | tr '\n' ' ')"
if [ "${code}" = 0 ]; then exit 0; fi

made=0
while IFS= read -r -d '' file; do
  IFS= read -r -N 4 magic <"${file}" || true
  if [ "${magic}" = $'\x7fELF' ]; then made=$((made + 1)); fi
done < <(find . -name CMakeFiles -prune -o -type f -newer "${before}" -perm -u+x ! -name '*.so*' -print0)
if [ "${made}" = 0 ]; then exit "${code}"; fi
echo "roslab: not compiled and left out: ${failed:-see above }(programs that are there: ${made})" >&2
