#!/bin/bash
# usage: make-what-compiles [--program NAME] COMMAND...
# Runs a command of make in the current folder and goes on where one of many programs does not compile: those that do are
# there, and the others are told. It ends as make did where no program was made, or not the one of that name.
set -euo pipefail

needed=''
if [ "$1" = --program ]; then
  needed="$2"
  shift 2
fi
code=0
said="$(mktemp)" before="$(mktemp)"
trap 'rm -f "${said}" "${before}"' EXIT # no layer keeps their names, which are others each time
"$@" --keep-going 2>&1 | tee "${said}" || code="${PIPESTATUS[0]}"
# Of the last run alone: where warnings-pass begins another, what the first could not compile may be there
failed="$(sed --quiet --regexp-extended --expression '/^roslab: the compiler stops at a warning/q' \
  --expression 's:^make.*[*]{3} \[([^]]* )?(.*/)?CMakeFiles/([^/]+)[.]dir/all\] Error.*:\3:p' \
  <(tac "${said}") | sort --unique | tr '\n' ' ')"
if [ "${code}" = 0 ]; then exit 0; fi

made=0 has=''
while IFS= read -r -d '' file; do
  IFS= read -r -N 4 magic <"${file}" || true
  if [ "${magic}" = $'\x7fELF' ]; then
    made=$((made + 1))
    if [ "${file##*/}" = "${needed}" ]; then has=yes; fi
  fi
done < <(find . -name CMakeFiles -prune -o -type f -newer "${before}" -perm -u+x ! -name '*.so*' -print0)
if [ "${made}" = 0 ] || [[ -n "${needed}" && -z "${has}" ]]; then exit "${code}"; fi
echo "roslab: not compiled and left out: ${failed:-see above }(programs that are there: ${made})" >&2
