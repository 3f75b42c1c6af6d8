#!/bin/bash
# usage: unfold-lists FILE
# Writes the lists of a conda environment's file that stand in brackets, `pip: [a, b]`, as one item on a line, as
# most files have them: what changes lines of the file, and what takes its part for pip, then finds each item.
set -euo pipefail

awk -v quotes="[\"']" '
  function item(text, indent) {
    gsub(/^[ \t]+|[ \t]+$/, "", text)
    if (text != "") print indent "- " text
  }
  # Writes the items of the list that begins at the place `at`, and ends behind it
  function items(indent,   sign, text, quote) {
    for (at++; at <= size; at++) {
      sign = substr(file, at, 1)
      if (quote != "") {
        text = text sign
        if (quote == "\"" && sign == "\\") text = text substr(file, ++at, 1)
        else if (sign == quote) quote = ""
        continue
      }
      if (sign == "\n" || sign == "\t") sign = " "
      if (sign == "#" && (text == "" || text ~ / $/)) {
        while (substr(file, at + 1, 1) != "\n" && at < size) at++
      } else if (sign ~ quotes && text ~ /^ *$/) {
        quote = sign
        text = text sign
      } else if (sign == "[") {
        item(text, indent)
        text = ""
        items(indent "    ")
      } else if (sign == "," || sign == "]") {
        item(text, indent)
        text = ""
        if (sign == "]") return
      } else if (sign != "{" && sign != "}") {
        text = text sign
      }
    }
  }
  { sub(/\r$/, ""); file = file $0 "\n" }
  END {
    size = length(file)
    for (at = 1; at <= size; at++) {
      rest = substr(file, at)
      line = substr(rest, 1, index(rest, "\n") - 1)
      if (match(rest, /^((channels|dependencies) *:|[ ]*- *([{] *)?pip *:)([ \t]*(#[^\n]*)?\n)*[ \t]*\[/)) {
        at += RLENGTH - 1
        indent = "  "
        if (match(line, /^ *- */)) indent = substr(line, 1, index(line, "-") - 1) "    "
        sub(/:.*/, ":", line)
        sub(/[{] */, "", line)
        print line
        items(indent)
        # What may stand behind it: a bracket, a comment
        while (at < size && substr(file, at, 1) != "\n") at++
      } else {
        print line
        at += length(line)
      }
    }
  }
' "$1" >"$1.unfolded"
mv "$1.unfolded" "$1"
