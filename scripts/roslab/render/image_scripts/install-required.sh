#!/bin/bash
# usage: install-required [NAME FOLDER [OPTION...]]
# Installs what the CMakeLists.txt in FOLDER of a library requires with these options of CMake: packages that the tables of
# the image's Ubuntu name, else those of ROS that are called so, else those that Debian's custom would call so: libNAME-dev
# or NAME-dev. A list of them goes along with the library to where it is installed, for what is linked with it needs them
# too: without arguments, all lists that came with libraries are installed, as they are before those of a further library.
# So are packages of headers that its code includes and its files of CMake never name, which are on no path of its own, and
# packages of which CMake asks apt-cache.
# What no package brings and CMake alone builds is built as the tables have it, here and for the image; the rest is told.
set -eo pipefail # not -u: an empty array is unset to the bash of Ubuntu 16.04

tables=/usr/local/share/roslab
lists="${tables}/required"
install() {
  local packages
  mapfile -t packages < <(find "${lists}" -name '*.txt' -exec cat {} + 2>/dev/null | LC_ALL=C sort --unique)
  if [ "${#packages[@]}" -gt 0 ]; then install-optional-apt "${packages[@]}"; fi
}
if [ $# = 0 ]; then install && exit; fi

name="$1" folder="$2"
shift 2
if [ ! -f "${folder}/CMakeLists.txt" ]; then exit 0; fi
apt-get update --quiet=2 --option pkgCacheFile::Generate=false
# Each call would read all lists anew: Docker's bases keep no cache of them
cache=(--option Dir::Cache::pkgcache=/tmp/apt-pkgcache.bin --option Dir::Cache::srcpkgcache=/tmp/apt-srcpkgcache.bin)
known() { apt-cache "${cache[@]}" show "$1" >/dev/null 2>&1; }
of_ros() { if [ -n "${ROS_DISTRO:-}" ]; then echo "ros-${ROS_DISTRO}-${1//_/-}"; else echo -; fi; }
# Prints the package that is called after a name as Debian calls those to compile with, where there is one
# https://www.debian.org/doc/debian-policy/ch-sharedlibs.html#development-files
of_debian() {
  local name="${1#pkg:}" package
  name="${name,,}" name="${name//_/-}" name="${name#lib}"
  if [[ ! "${name}" =~ ^[a-z0-9][a-z0-9.+-]{2,}$ ]]; then return; fi # of one or two letters there is always another one
  for package in "lib${name}-dev" "${name}-dev"; do if known "${package}"; then echo "${package}" && return; fi; done
}
# Prints what the tables say of a name; of a header also what they say of its folder
told() {
  awk -F' = ' -v name=" ${1,,} " 'index(" " $1 " ", name) { print $2; exit }' "${tables}"/{libraries,cmake}-*.txt
}
# Of what is built from its source already, nothing is installed
installed() {
  [ -n "$(find /usr/local/{lib,share} -iname "$1config.cmake" -o -iname "$1-config.cmake" -o -name "${1#pkg:}.pc" 2>/dev/null)" ]
}
# Prints header:PATH of what the code includes, is no file of the folder, and goes by no name in its files of CMake: what
# these look for they may do without. Tests, examples and what is copied into it are not read.
included() {
  local path part aside=({.git,build,{third,3rd}{,-,_}party,extern,external,externals,vendor,doc,docs}) here cmake
  aside+=(test tests testing example examples demo demos sample samples benchmark benchmarks win32 windows android)
  here="$(find "${folder}" -name .git -prune -o -printf '%f\n' | LC_ALL=C sort --unique)"
  cmake="$(find "${folder}" \( -name CMakeLists.txt -o -name '*.cmake' -o -name '*.cmake.in' \) -xtype f \
    -exec cat {} +)"
  { grep --recursive --no-filename --only-matching --text --extended-regexp "${aside[@]/#/--exclude-dir=}" \
    --include='*.'{h,hh,hpp,hxx,c,cc,cpp,cxx} '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"][A-Za-z0-9_./+-]+[>"]' \
    "${folder}" || true; } | sed --expression 's/.*[<"]\(.*\)[>"]/\1/' | LC_ALL=C sort --unique |
    awk 'NR == FNR { for (i = 1; i <= NF && $i != "="; i++) known[$i]; next } # those that the tables know
      { first = path = "header:" tolower($0); sub(/\/.*/, "/", first) }
      path in known || first in known' <(cat "${tables}"/libraries-*.txt) - | while read -r path; do
    if [[ "${path}" =~ ^Q([A-Z]|t) ]]; then continue; fi # each component of Qt has a package
    if grep --quiet --line-regexp --fixed-strings -- "${path%%/*}" <<<"${here}"; then continue; fi
    part="$(sed --regexp-extended --expression 's/\/[^/]*$//' --expression 's/\.[a-z]+$//' \
      --expression 's/(^|\/)lib/\1/g' --expression 's/[0-9.-]+(\/|$)/\1/g' \
      --expression 's/\//|/g' --expression 's/[.+]/./g' <<<"${path}")"
    if ! grep --quiet --ignore-case --extended-regexp -- "${part}" <<<"${cmake}"; then printf 'header:%s\n' "${path}"; fi
  done
}
# Prints the packages of which CMake asks apt-cache: without lists, which no layer keeps, that knows what is installed alone
asked_of_apt() {
  local package
  { grep --recursive --no-filename --only-matching --extended-regexp --exclude-dir=.git --include=CMakeLists.txt --include='*.cmake' \
    '^[^#]*\bapt-cache +(show|policy) +[a-z0-9][a-z0-9.+-]+' "${folder}" || true; } | sed 's/.* //' | while read -r package; do
    if known "${package}"; then echo "${package}"; fi
  done
}
packages() {
  local wanted said ros package found
  asked_of_apt
  { required-by-cmake --library "${folder}" "$@" && included; } | while read -r wanted; do
    if installed "${wanted}"; then continue; fi
    said="$(told "${wanted}")"
    if [ -z "${said}" ] && [[ "${wanted}" = header:*/* ]]; then said="$(told "${wanted%%/*}/")"; fi
    ros="$(of_ros "${wanted,,}")"
    if [[ "${said}" = ros:* ]]; then
      ros="${said%% *}" ros="$(of_ros "${ros#ros:}")"
      if known "${ros}"; then said="${ros}"; else said="${said#"${said%% *}"}" said="${said# }"; fi
    fi
    case "${said}" in
      -) ;; # CMake or the compiler has it
      recipe:* | '')
        if known "${ros}"; then echo "${ros}" && continue; fi
        if [[ "${wanted}" = link:* || "${wanted}" = header:* ]]; then continue; fi
        package="$(if [ -z "${said}" ]; then of_debian "${wanted}"; fi)"
        if [ -n "${package}" ]; then
          echo "roslab: ${name} requires ${wanted#pkg:}, which no table knows: ${package} is taken, which is called so" >&2
          echo "${package}"
          continue
        fi
        echo "roslab: ${name} requires ${wanted#pkg:}, and no package of this image's sources is known to bring it" >&2
        if [ -n "${said}" ]; then echo "${said#recipe:}" >>"${recipes}"; fi
        ;;
      *)
        found=''
        for package in ${said}; do if known "${package}"; then echo "${package}" && found=yes; fi; done
        if [ -z "${found}" ] && [[ "${wanted}" != link:* && "${wanted}" != header:* ]]; then
          echo "roslab: ${name} requires ${wanted#pkg:}, and this image's sources do not have ${said}, which brings it" >&2
        fi
        ;;
    esac
  done
}
# Builds what a line of the tables tells, one library before the other; ends with 1 where one needs more than CMake
form='^\{"name": "([^"\\]+)", "repo": "([^"\\]+)", "ref": "([^"\\]+)"'
form+='(, "depends": \[([^]\\]*)\])?(, "cmake_options": "([^"\\]*)")?\}$'
with_packages() {
  if [ "$#" -eq 0 ]; then return; fi
  printf '%s\n' "$@" | tee --append "/installed${lists}/${name}.txt" >>"${lists}/${name}.txt"
  install-optional-apt "$@"
}
build() {
  local one source url ref depends options
  while IFS='' read -r one; do
    if [[ ! "${one}" =~ ${form} ]]; then return 1; fi
    source="/tmp/required/${BASH_REMATCH[1]}" url="${BASH_REMATCH[2]}" ref="${BASH_REMATCH[3]}"
    read -r -a depends <<<"$(tr --delete '",' <<<"${BASH_REMATCH[5]}")"
    mapfile -t options < <(xargs --no-run-if-empty printf '%s\n' <<<"${BASH_REMATCH[7]}")
    if [ -d "${source}" ]; then continue; fi # another one of these names needed it, too
    echo "roslab: ${name} requires $(basename "${source}"): ${ref} of ${url} is built before it"
    { git clone --quiet "${url}" "${source}" && git -C "${source}" -c advice.detachedHead=false checkout --quiet "${ref}" &&
      fetch-submodules "${source}" && with_packages "${depends[@]}" &&
      mkdir --parents "${source}/build" && (cd "${source}/build" && cmake -DCMAKE_BUILD_TYPE=Release "${options[@]}" .. &&
      make --jobs="$(compile-jobs 2>/dev/null || echo 2)" && make install && make install DESTDIR=/installed) && ldconfig; } </dev/null || {
      rm -rf "${source}"
      return 1
    }
  done <<<"${1// | /$'\n'}"
}

recipes="$(mktemp)"
mkdir --parents "${lists}" "/installed${lists}"
packages "$@" | LC_ALL=C sort --unique >"${lists}/${name}.txt"
# vcpkg, which the library's own CMake fetches, starts with these programs
# https://learn.microsoft.com/en-us/vcpkg/concepts/supported-hosts, 2026-11-28
if grep --quiet --recursive --binary-files=without-match --include=CMakeLists.txt --include='*.cmake' bootstrap-vcpkg "${folder}"; then
  echo "roslab: CMake of ${name} fetches vcpkg: what starts that is installed"
  printf '%s\n' curl ninja-build pkg-config tar unzip zip >>"${lists}/${name}.txt"
fi
rm -f /tmp/apt-*.bin
cp "${lists}/${name}.txt" "/installed${lists}/"
if [ -s "${lists}/${name}.txt" ]; then echo "roslab: ${name} requires, and apt installs: $(tr '\n' ' ' <"${lists}/${name}.txt")"; fi
install
while IFS='' read -r recipe; do
  if build "${recipe}"; then continue; fi
  echo "roslab: it can be built before ${name}; write into roslab.yaml:" >&2
  sed -e 's/^/format: 3\nsource:\n  - /' -e 's/ | /\n  - /g' <<<"${recipe}" >&2
done < <(LC_ALL=C sort --unique "${recipes}")
rm -rf "${recipes}" /tmp/required
