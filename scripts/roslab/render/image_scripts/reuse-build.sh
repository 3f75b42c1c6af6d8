#!/bin/bash
# usage: reuse-build COMMAND...
# Compiles the ROS workspace in the current folder and moves what runs to ../built, without the build tree. What CMake
# adds to the source on its way, as models that it downloads beside a CMakeLists.txt, goes there, too.
# Where a cache is mounted, the build tree is taken from it, and kept there for the next build. It is taken only if all
# is as it was but the contents of code: the command, the packages, the libraries in /usr/local and /opt, the names of
# the source's files, and what is in those that are no code. Else, and without a cache, everything is compiled: by with-ccache,
# if the command names it, only what is not the very same as in an earlier build.
set -euo pipefail

cache=/var/cache/roslab-build
trees=({build,devel,install}{,_isolated} .catkin_tools .written)
code='.*\.(c|cc|cpp|cxx|cu|h|hh|hpp|hxx|cuh|inl|ipp|tpp|py|launch)'
headers='.*\.(h|hh|hpp|hxx|cuh|inl|ipp|tpp|cmake|pc|a|msg|srv|action|idl)'

# A Python file or a launch file may be read while CMake runs, and make would not know
if grep --recursive --quiet --include=CMakeLists.txt --include='*.cmake' --extended-regexp \
  '(execute_process|exec_program|file *\( *(READ|STRINGS))' src; then
  code='.*\.(c|cc|cpp|cxx|cu|h|hh|hpp|hxx|cuh|inl|ipp|tpp)'
fi
tracked() { find src -type d -name .git -prune -o -type f -regextype posix-extended "$@" -print0 | sort --zero-terminated; }
present() { for tree in "${trees[@]}"; do if [ -e "${tree}" ]; then echo "${tree}"; fi; done; }

# What a kept tree must have been built with
of_image() {
  dpkg-query --show
  find /usr/local /opt -path '/usr/local/cuda*' -prune -o -name '*-info' -print | sort
  find /usr/local /opt -path '/usr/local/cuda*' -prune -o -type f -regextype posix-extended -regex "${headers}" -print0 |
    sort --zero-terminated | xargs --null --no-run-if-empty sha256sum
}
of_source() {
  # The number is another where this script keeps a tree otherwise, for it would take one of a script before it for its own
  echo "2 $*" | sed --regexp-extended 's/(-[jl]|(jobs|packages|workers)[ =])[0-9]+//g'
  # Without what each build has anew: BuildKit hands a number to those who trace it
  env | grep --invert-match --extended-regexp \
    '^(HOSTNAME|MAKEFLAGS|OLDPWD|OTEL_\w+|PWD|SHLVL|SOURCE_DATE_EPOCH|TRACEPARENT|TRACESTATE|_)=' | sort
  find src -name .git -prune -o -printf '%y %p %l\n' | sort
  tracked -not -regex "${code}" | xargs --null --no-run-if-empty sha256sum
}

# The files of the source, but what compilers and hidden packages leave behind
source_files() {
  find src \( -name .git -o -name __pycache__ -o -name CMakeFiles \) -prune -o \( -type f -o -type l \) \
    -not -name '*.o' -not -name '*_IGNORE' -print | sort
}
before=.source-files # where a build failed before this one, what it has added is new all the same
if [ ! -e "${before}" ]; then source_files >"${before}"; fi
seen="$(mktemp --directory)"
looking=''
if [ -d "${cache}" ]; then
  of_image | sha256sum >"${seen}/image" &
  looking=$!
  of_source "$@" | sha256sum >"${seen}/source"
  tracked -regex "${code}" | xargs --null --no-run-if-empty sha256sum >"${seen}/contents"
  # Where nothing was kept, the image is looked at while everything is compiled
  if [ -e "${cache}/fingerprint" ]; then wait "${looking}" && looking=''; fi
fi
# Brings the kept tree up to date by what has changed alone, which is quicker than to copy all of it
listing() { (cd "$1" && find "${found[@]}" -printf '%y %m %s %T@ %l\t%p\n' | sort); }
renew() {
  local made kept
  made="$(listing .)" && kept="$(listing "${cache}/tree")" &&
    comm -13 <(cut --fields=2- <<<"${made}" | sort) <(cut --fields=2- <<<"${kept}" | sort) |
    (cd "${cache}/tree" && xargs --delimiter='\n' --no-run-if-empty rm -rf) &&
    comm -23 <(echo "${made}") <(echo "${kept}") | cut --fields=2- |
    tar --create --no-recursion --no-unquote --files-from=- |
      tar --extract --same-permissions --directory="${cache}/tree"
}

reused=''
if [ -d "${cache}/tree" ] && cmp --silent "${cache}/fingerprint" <(cat "${seen}"/{source,image}); then
  echo "roslab: only code has changed since the last build: its build tree is used again"
  reused=yes
  # A checkout gives every file a time of its own. To make, the tree is newer than all of it but what has changed, and
  # no file of the tree newer than another: CMake would begin anew.
  find "${cache}/tree" -exec touch --no-dereference --date="$(date --date='2 seconds ago' '+%F %T.%N')" {} +
  # But CMake reads each file's headers again unless its own list of them is newer
  find "${cache}/tree" -name 'compiler_depend.*' -not -name '*.ts' \
    -exec touch --date="$(date --date='1.5 seconds ago' '+%F %T.%N')" {} +
  cp --archive "${cache}/tree/." .
  if [ -e .written ]; then cp --archive .written/. . && rm -rf .written; fi
  comm -13 <(sort "${cache}/contents") <(sort "${seen}/contents") | cut --characters=67- |
    xargs --delimiter='\n' --no-run-if-empty touch --date='1 second ago'
fi

compile() { if command -v with-ccache >/dev/null; then with-ccache --told "$@"; else "$@"; fi; }
# With a kept tree catkin_make calls make alone, after it has looked for all packages; make calls CMake itself where it must
make=()
if [ -n "${reused}" ] && [ -e build/Makefile ] && [[ "$*" =~ ^headers-first\ catkin_make(\ -[jlD][^\ ]*)*$ ]]; then
  make=(make --no-print-directory --directory=build)
  for word in "$@"; do if [[ "${word}" = -[jl]* ]]; then make+=("${word}"); fi; done
fi

rm --force "${cache}/fingerprint" # what fails is not used again
if [ "${#make[@]}" -eq 0 ] || ! compile "${make[@]}"; then compile "$@"; fi
source_files | comm -13 "${before}" - >"${seen}/new"
rm "${before}"
if [ -s "${seen}/new" ]; then
  mkdir .written
  xargs --delimiter='\n' cp --archive --parents --target-directory=.written <"${seen}/new"
fi

# CMake 3.20 and newer lists for make which headers each file has. What is in the image goes from these lists, but for a first
# name: a tree is taken only where that is the same, and make would look at thousands. A list that is not newer than all that the
# compiler has told since is removed, so that CMake makes it anew.
old_lists() {
  find "${found[@]}" \( -name '*.d' -o -name compiler_depend.internal \) -printf '%T@ %p\n' | awk '{
    time = $1 + 0
    sub(/^[^ ]+ /, "")
    if (!match($0, /\/CMakeFiles\/[^\/]+\.dir\//)) next
    target = substr($0, 1, RSTART + RLENGTH - 1)
    if (/\/compiler_depend\.internal$/) listed[target] = time; else if (time > told[target]) told[target] = time
  } END { for (target in listed) if (told[target] >= listed[target]) print target "compiler_depend.internal" }'
  # What another program than a compiler tells (DEPFILE) may lie anywhere
  { find "${found[@]}" -name DependInfo.cmake -exec grep --files-with-matches --fixed-strings '" "custom" "' {} + || true; } |
    sed 's/DependInfo\.cmake$/compiler_depend.internal/'
}
long_lists() {
  find "${found[@]}" -name 'compiler_depend.*' -exec grep --files-with-matches --extended-regexp '^ +/(usr|opt)/' {} + || true
}
mapfile -t found < <(present)
if [ "${#found[@]}" -gt 0 ]; then
  old_lists | xargs --delimiter='\n' --no-run-if-empty rm --force
  long_lists | xargs --delimiter='\n' --no-run-if-empty sed --in-place --regexp-extended \
    -e '\#^/(usr|opt)/.*:$#d' -e '/^[^ #].*[^\\:]$/ { n; b; }' -e '\#^ +/(usr|opt)/#d'
fi

if [ -d "${cache}" ]; then
  if [ -z "${reused}" ] || ! renew; then
    rm -rf "${cache}/tree" "${cache}/new"
    mkdir "${cache}/new"
    cp --archive "${found[@]}" "${cache}/new"
    mv "${cache}/new" "${cache}/tree"
  fi
  if [ -n "${looking}" ]; then wait "${looking}"; fi
  cp "${seen}/contents" "${cache}"
  cat "${seen}"/{source,image} >"${cache}/fingerprint"
fi
rm -rf "${seen}"
# A program may load a library out of the build tree; then only the compiler's own files go, and CMake's logs, which name
# random targets, others at each build
mapfile -t built < <(present | grep --line-regexp --extended-regexp 'build(_isolated)?')
mapfile -t found < <(present | grep --line-regexp --extended-regexp --invert-match 'build(_isolated)?')
links_to_build() { [ -n "$(find "${found[@]}" -type l -lname "${PWD}/build*" -print -quit)" ]; }
if [ "${#built[@]}" -gt 0 ] &&
  { links_to_build || grep --recursive --quiet --extended-regexp "${PWD}/build(_isolated)?/" "${found[@]}"; }; then
  find "${built[@]}" \( -name '*.o' -o -path '*/CMakeFiles/CMake*.log' -o -name CMakeConfigureLog.yaml \) -delete
  found+=("${built[@]}")
fi
mkdir --parents ../built
mv "${found[@]}" ../built
if [ -e ../built/.written ]; then mv ../built/.written/* ../built && rmdir ../built/.written; fi
rm -rf build build_isolated log logs
