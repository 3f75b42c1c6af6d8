#!/bin/bash
# usage: take-pip-part FILE
# Moves the list that a conda environment's file has for pip to FILE.pip, which pip reads once the environment is there:
# with the environment's own Python, and so from the index of a day. What it includes is found from the same folder.
# Lists in brackets were unfolded before.
set -euo pipefail

awk -v list="$1.pip" -v quotes="[\"']" '
  function column() { return match($0, /[^ ]/) }
  BEGIN { printf "" >list }
  { sub(/\r$/, "") }
  !inside && /^ *- *pip *: *(#.*)?$/ { inside = column(); next }
  inside && /^ *(#.*)?$/ { next }
  inside && column() > inside {
    sub(/^ *- */, "")
    quote = substr($0, 1, 1)
    if (quote ~ quotes) {
      $0 = substr($0, 2)
      $0 = substr($0, 1, index($0, quote) - 1)
    } else {
      sub(/[ \t]+(#.*)?$/, "")
    }
    if ($0 != "") print >list
    next
  }
  { inside = 0; print }
' "$1" >"$1.conda"
mv "$1.conda" "$1"
