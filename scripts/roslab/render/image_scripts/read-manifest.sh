#!/bin/bash
# usage: read-manifest name|depends FILE...
# Prints what package.xml files tell, each on a line:
#   name     the name of each package
#   depends  what the packages need, whatever for
set -euo pipefail

case "$1" in
  name) element=name after=q ;;
  depends) element='[a-z_]*depend' after='' ;;
esac
shift
for file in "$@"; do
  # shellcheck disable=SC1003 # no quote is meant: sed ends the last line, which may have no end
  sed --regexp-extended "
    \\,.*<${element}( [^>]*)?>[[:space:]]*([^<]*[^<[:space:]])[[:space:]]*(<.*)?\$,!d
    s,,\\2,
    ${after}" "${file}" | sed '$a\'
done
