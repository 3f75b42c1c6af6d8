#!/bin/bash
# usage: make-installed-folders FOLDER
# Makes the folders that packages below a folder install and do not have: git keeps no empty ones, and `cmake --install` ends
# there. None where the CMakeLists.txt may make it itself, nor what it installs under a condition or in a function.
set -euo pipefail

# Each command on a line of its own, without comments and quotes
commands() {
  sed 's/#.*//' "$1" | tr '\n\t\r"' '    ' | sed --regexp-extended 's/([A-Za-z_][A-Za-z0-9_]*) *\(/\n\1 (/g'
}
# Reads commands and prints paths from the folder of their file
installed() {
  awk '
    {
      command = tolower($1)
      text = substr($0, index($0, "(") + 1)
      sub(/\)[^)]*$/, "", text)
      count = split(text, words, " ")
    }
    command ~ /^(execute_process|configure_file|add_custom_command|externalproject_add)$/ { writes = 1 }
    command == "file" && words[1] ~ /^(DOWNLOAD|MAKE_DIRECTORY|WRITE|APPEND|COPY|GENERATE|CONFIGURE|ARCHIVE_EXTRACT)$/ { writes = 1 }
    command ~ /^(if|function|macro)$/ { depth++ }
    command ~ /^end(if|function|macro)$/ { depth-- }
    command == "project" { name = words[1]; own = 1 }
    depth > 0 || text ~ /(^| )OPTIONAL( |$)/ { next }
    {
      first = 0
      if (command == "install" && words[1] == "DIRECTORY") first = 2
      if (command == "ament_auto_package") for (i = 1; i <= count; i++) if (words[i] == "INSTALL_TO_SHARE") first = i + 1
      for (i = first; first && i <= count; i++) {
        if (words[i] ~ /^[A-Z_]+$/ && words[i] ~ /^(DESTINATION|TYPE|FILES_MATCHING|PATTERN|REGEX|COMPONENT|CONFIGURATIONS|EXCLUDE_FROM_ALL|MESSAGE_NEVER)$|PERMISSIONS$/) break
        path = words[i]
        sub(/^\$\{CMAKE_CURRENT_SOURCE_DIR\}\//, "", path)
        if (own) sub(/^\$\{PROJECT_SOURCE_DIR\}\//, "", path) # of a file above, it is the folder of that
        gsub(/\$\{PROJECT_NAME\}/, name, path)
        if (path ~ /^[A-Za-z0-9_.+@-][A-Za-z0-9_.+@\/-]*$/ && path !~ /(^|\/)\.\.?(\/|$)/) found[++total] = path
      }
    }
    END { if (!writes) for (i = 1; i <= total; i++) print found[i] }'
}

find "$1" -name .git -prune -o -name CMakeLists.txt -print | sort | while read -r file; do
  if [ ! -f "${file}" ]; then continue; fi # a link of catkin's to another machine's distribution
  commands "${file}" | installed | while read -r path; do
    path="$(dirname "${file}")/${path%/}"
    if [ -e "${path}" ] || [ -L "${path}" ]; then continue; fi
    mkdir --parents "${path}" || continue
    echo "roslab: made empty: ${path}, which ${file} installs and git does not keep"
  done
done
