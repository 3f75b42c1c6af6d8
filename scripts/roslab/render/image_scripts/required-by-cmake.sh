#!/bin/bash
# usage: required-by-cmake FILE...
#        required-by-cmake --programs FILE...
#        required-by-cmake --library FOLDER [OPTION...]
# Prints the names of what CMakeLists.txt files require: components of catkin, and packages. What stands below a condition
# that is off is left out: an option or variable that the file itself turns off, and systems that the image is not. So is
# what the file has another way for (it looks for others in the else of if(NAME_FOUND)), where its own FindNAME.cmake never
# stops. Files that they include are read with them.
#   --programs  run:NAME of each program that they call, also of a script that lies in what they fetch
#   --library  of a library that CMake configures with these options: its CMakeLists.txt with the files that it adds, too,
#              without what its own projects are called. Also Qt5NAME for a component of Qt, pkg:MODULE for a module of
#              pkg-config, and link:NAME and header:NAME for what find_library and find_path look for and every build
#              uses, and for what it links by the name alone
set -eu # a search that finds nothing is no failure

# Each command on a line of its own, without comments and texts; with the words of texts if TEXTS is set: FILE TEXTS
commands() {
  sed 's/#.*//' "$1" | tr '\n\t\r' '   ' |
    if [ -n "${2:-}" ]; then sed 's/[";]/ & /g; s/"//g'; else sed 's/"[^"]*"/""/g'; fi |
    sed --regexp-extended 's/([A-Za-z_][A-Za-z0-9_]*) *\(/\n\1 (/g'
}
# The same, with the commands of a file that is added or included below that command, as CALLS says: FILE ITS_FOLDER LEVEL
calls=include
with_added() {
  local line path found places
  commands "$1" | while IFS='' read -r line || [ -n "${line}" ]; do
    printf '%s\n' "${line}"
    if [[ ! "${line,,}" =~ ^(${calls})\ \( ]] || [ "$3" -gt 5 ]; then continue; fi
    read -r path _ <<<"$(tr '()' '  ' <<<"${line#*(}")"
    path="${path#\$\{*SOURCE_DIR\}/}" path="${path#\$\{CMAKE_CURRENT_LIST_DIR\}/}"
    if [[ ! "${path}" =~ ^[A-Za-z0-9_./+-]+$ ]]; then continue; fi
    if [[ "${line,,}" = add_subdirectory* ]]; then places=({"$2","${top}"}"/${path}/CMakeLists.txt"); else
      places=({"$2/","${top}/","${top}/cmake/"}"${path}"{,.cmake})
    fi
    for found in "${places[@]}"; do
      if [ ! -f "${found}" ]; then continue; fi
      # One that is added again tells nothing new
      if grep --quiet --line-regexp --fixed-strings "$(realpath "${found}")" "${seen}"; then break; fi
      realpath "${found}" >>"${seen}"
      if [[ "${line,,}" = include* ]]; then with_added "${found}" "$2" "$(($3 + 1))"; else
        with_added "${found}" "${found%/*}" "$(($3 + 1))"
      fi
      break
    done
  done
}

# Reads commands; GIVEN are the options of CMake. What is looked for is a library, programs, or, if nothing is said, the
# packages of a file; only those of a library are not printed as they come: WHAT GIVEN
required() {
  awk -v library="${1#programs}" -v programs="${1#library}" -v given="${2:-}" '
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
    function take(names,    i, all, total) {
      total = split(names, all, " ")
      for (i = 1; i <= total; i++) if (library) taken[all[i]] = 1; else print all[i]
    }
    # The components of Qt, each of which has a package of its own name: " Qt5Core Qt5Svg"
    function parts(words, count,    i, all) {
      if (words[1] !~ /^Qt[0-9]$/) return ""
      for (i = 2; i <= count; i++) {
        if (words[i] == "OPTIONAL_COMPONENTS") break
        if (words[i] ~ /^[A-Z][A-Za-z0-9]*[a-z][A-Za-z0-9]*$/) all = all " " words[1] words[i]
      }
      return all
    }
    # The variables and the targets by which a package is used that CMake may not find
    function note_found(name,    i, ends, total) {
      total = split("_INCLUDE_DIRS} _INCLUDE_DIR} _LIBRARIES} _LIBRARY} _LIBS}", ends, " ")
      for (i = 1; i <= total; i++) found["${" name ends[i]] = found["${" toupper(name) ends[i]] = name
      found[name "::"] = name
    }
    BEGIN {
      value["WIN32"] = value["MSVC"] = value["APPLE"] = value["ANDROID"] = value["IOS"] = 0
      total = split(given, options, " ")
      for (i = 1; i <= total; i++) {
        split(options[i], pair, "=")
        sub(/:.*/, "", pair[1])
        note(pair[1], pair[2])
        set_outside[pair[1]] = 1
      }
    }
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
    command == "if" { asked[depth] = count == 1 && tolower(words[1]) ~ /_found$/ ? tolower(words[1]) : "" }
    command ~ /^(if|elseif|else)$/ { otherwise[depth] = command == "else" ? asked[depth] : "" }
    command ~ /^(find_package|find_library|pkg_check_modules)$/ {
      for (level = 1; level <= depth; level++) {
        if (otherwise[level]) either[substr(otherwise[level], 1, length(otherwise[level]) - 6)] = 1
      }
    }
    command ~ /^(if|elseif|else)$/ { without[depth] = count == 2 && toupper(words[1]) == "NOT" ? words[2] : "" }
    {
      for (level = 1; level <= depth; level++) if (skip[level]) next
    }
    command == "option" && !(words[1] in set_outside) {
      note(words[1], count > 1 && words[count] != "\"\"" ? words[count] : "OFF")
    }
    command == "set" && count > 1 && !(words[1] in set_outside && / CACHE /) {
      if (depth > 0) delete value[words[1]]; else note(words[1], words[2])
    }
    programs && command == "find_program" { program["${" words[1] "}"] = words[words[2] == "NAMES" ? 3 : 2] }
    programs && command ~ /^(externalproject_add(_step)?|execute_process|exec_program|add_custom_(command|target))$/ {
      begins = command == "exec_program"
      for (i = 1; i <= count; i++) {
        if (words[i] ~ /^(SVN|HG)_REPOSITORY$/) print "run:" tolower(substr(words[i], 1, index(words[i], "_") - 1))
        if (words[i] ~ /^([A-Za-z0-9_]+_)?COMMAND$/ || words[i] ~ /^(&&|[|][|]?|;)$/) begins = 1
        else if (begins && words[i] !~ /^((.*\/)?(ba|da)?sh|env|sudo|cmake|[$][{]CMAKE_COMMAND[}]|-.*|[A-Za-z0-9_]+=.*)$/) {
          name = words[i] in program ? program[words[i]] : words[i]
          sub(/.*\//, "", name)
          print "run:" name
          begins = 0
        }
      }
    }
    programs { next }
    command == "find_package" {
      required = components = quiet = 0
      for (i = 2; i <= count; i++) {
        if (words[i] == "REQUIRED") required = 1
        if (words[i] == "QUIET") quiet = 1
        if (words[i] == "COMPONENTS") components = 1
        else if (components && words[1] == "catkin") take(words[i])
      }
      if (required && words[1] != "catkin") if (library) take(words[1] parts(words, count)); else packages[++total_packages] = words[1]
      looked[words[1] "_FOUND"] = looked[toupper(words[1]) "_FOUND"] = words[1]
      if (depth == 0 && !quiet && words[1] != "catkin") note_found(words[1])
    }
    !library { next }
    command == "project" { own[tolower(words[1])] = 1 }
    command ~ /^(add_(library|executable)|externalproject_add|fetchcontent_declare)$/ { made[words[1]] = 1 }
    command ~ /^pkg_(check_modules|search_module)$/ {
      required = 0
      modules = ""
      for (i = 2; i <= count; i++) {
        if (words[i] == "REQUIRED") required = 1
        sub(/[<>=].*/, "", words[i])
        if (words[i] ~ /[a-z]/ && !(modules && command ~ /search/)) modules = modules " pkg:" words[i]
      }
      if (required) take(modules)
      looked[words[1] "_FOUND"] = modules
    }
    command ~ /^find_(library|path)$/ && count > 1 {
      name = words[2] == "NAMES" ? words[3] : words[2]
      if (command == "find_library") sub(/^lib/, "", name)
      name = (command == "find_path" ? "header:" : "link:") name
      looked[words[1]] = name
      if (depth == 0) found["${" words[1] "}"] = name
      for (i = 3; i <= count; i++) if (words[i] == "REQUIRED") take(name)
    }
    # What is used in any case, and what stops CMake where it is not there
    depth == 0 && command ~ /^(target_)?(link_libraries|include_directories)$/ {
      for (i = 1; i <= count; i++) {
        if (words[i] in found) take(found[words[i]])
        else if (match(words[i], /^[A-Za-z0-9_.-]+::/) && (substr(words[i], 1, RLENGTH) in found)) {
          take(found[substr(words[i], 1, RLENGTH)])
        }
      }
    }
    depth == 0 && command ~ /^(target_)?link_libraries$/ {
      for (i = command == "link_libraries" ? 1 : 2; i <= count; i++) {
        word = words[i]
        sub(/^-l/, "", word)
        if (word ~ /^[A-Za-z0-9_.+-]+$/ && word !~ /^([A-Z_]+|debug|optimized|general|-.*)$/) linked[word] = 1
      }
    }
    command == "message" && words[1] == "FATAL_ERROR" && depth > 0 && without[depth] in looked { take(looked[without[depth]]) }
    END {
      for (name in taken) if (!(tolower(name) in own)) print name
      for (name in linked) if (!(name in made) && !(tolower(name) in own)) print "link:" name
      for (i = 1; i <= total_packages; i++) print (tolower(packages[i]) in either ? "either:" : "") packages[i]
    }'
}
# Reads names, and prints those without which the file in a folder stops: FOLDER
settled() {
  local name modules stops='handle_standard_args|(FATAL|SEND)_ERROR'
  while read -r name; do
    modules=()
    if [[ "${name}" =~ ^either:[A-Za-z0-9_+-]+$ ]]; then
      mapfile -t modules < <(find "$1" -name .git -prune -o -name "Find${name#either:}.cmake" -print)
    fi
    if [ "${#modules[@]}" -eq 0 ] || grep --quiet --ignore-case --extended-regexp "${stops}" "${modules[@]}"; then
      printf '%s\n' "${name#either:}"
    fi
  done
}

seen="$(mktemp)"
trap 'rm -f "${seen}"' EXIT
if [ "$1" = --library ]; then
  top="$2" calls='add_subdirectory|include'
  given="$(printf '%s\n' "${@:3}" | sed --quiet --regexp-extended 's/^-D([A-Za-z0-9_]+(:[A-Z]+)?=[A-Za-z0-9]+)$/\1/p' | tr '\n' ' ')"
  with_added "${top}/CMakeLists.txt" "${top}" 0 | required library "${given}"
elif [ "$1" = --programs ]; then
  for file in "${@:2}"; do commands "${file}" texts | required programs; done
else
  for file in "$@"; do
    top="$(dirname "${file}")"
    : >"${seen}" # another file may have turned off what it includes
    with_added "${file}" "${top}" 0 | required '' | settled "${top}"
  done
fi | grep --line-regexp --extended-regexp '((pkg|link|header|run):)?[A-Za-z][A-Za-z0-9_+./-]*' |
  grep --line-regexp --invert-match REQUIRED | LC_ALL=C sort --unique
