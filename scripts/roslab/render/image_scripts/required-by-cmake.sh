#!/bin/bash
# usage: required-by-cmake FILE...
# Prints the names of what CMakeLists.txt files require: components of catkin, and packages. What stands below a condition
# that is off is left out: an option or variable that the file itself turns off, and systems that the image is not.
set -eu # a search that finds nothing is no failure

# Each command on a line of its own, without comments and texts
commands() {
  sed 's/#.*//' "$1" | tr '\n\t\r' '   ' |
    sed --regexp-extended 's/"[^"]*"/""/g; s/([A-Za-z_][A-Za-z0-9_]*) *\(/\n\1 (/g'
}
for file in "$@"; do
  commands "${file}" | awk '
    function truth(words, count,    name) { # 1 on, 0 off, -1 unknown
      name = words[count]
      if (count > 2 || (count == 2 && toupper(words[1]) != "NOT") || !(name in value)) return -1
      return count == 2 ? 1 - value[name] : value[name]
    }
    function note(name, word) {
      word = toupper(word)
      if (word ~ /^(OFF|FALSE|NO|0)$/) value[name] = 0
      else if (word ~ /^(ON|TRUE|YES|1)$/) value[name] = 1
      else delete value[name]
    }
    BEGIN { value["WIN32"] = value["MSVC"] = value["APPLE"] = value["ANDROID"] = value["IOS"] = 0 }
    {
      command = tolower($1)
      text = substr($0, index($0, "(") + 1)
      sub(/\).*/, "", text)
      count = split(text, words, " ")
    }
    command == "endif" && depth > 0 { depth-- }
    command == "if" { depth++; known = truth(words, count); skip[depth] = known == 0; met[depth] = known == 1 }
    command == "elseif" { known = truth(words, count); skip[depth] = met[depth] || known == 0; if (known == 1) met[depth] = 1 }
    command == "else" { skip[depth] = met[depth] }
    {
      for (level = 1; level <= depth; level++) if (skip[level]) next
    }
    command == "option" { note(words[1], count > 1 && words[count] != "\"\"" ? words[count] : "OFF") }
    command == "set" && count > 1 { if (depth > 0) delete value[words[1]]; else note(words[1], words[2]) }
    command == "find_package" {
      required = components = 0
      for (i = 2; i <= count; i++) {
        if (words[i] == "REQUIRED") required = 1
        if (words[i] == "COMPONENTS") components = 1
        else if (components && words[1] == "catkin") print words[i]
      }
      if (required && words[1] != "catkin") print words[1]
    }'
done | grep --line-regexp --extended-regexp '[A-Za-z][A-Za-z0-9_+.-]*' | grep --line-regexp --invert-match REQUIRED |
  LC_ALL=C sort --unique
