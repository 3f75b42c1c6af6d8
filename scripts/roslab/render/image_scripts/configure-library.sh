#!/bin/bash
# usage: configure-library [OPTION...] FOLDER
# Configures a library of which nothing could be read when the image was planned, or that a table tells how to build on
# any Ubuntu, in the current folder.
# Where it has no CMakeLists.txt, the only folder of it that is a project is configured; else its own configure is called, or a
# Makefile is written here that installs it by its own with install-by-make.
# Where CMake says that it is too old, pip brings a newer one for the library alone, and it is configured again.
# Where CMake fails for programs that it names, those that are packages of apt under that name are installed and it is
# configured again. Where the library's own page or CI gives CMake an option that brings its dependencies
# (-DINSTALL_DEPS=ON), it is configured with that then, and what that installs is kept with the library.
# Where it still fails, it is configured once more without what its own options leave out and nothing
# links: bindings for other languages, tests, examples, benchmarks, documentation. Options that are given stay as they are.
# Where it fails in the end, what CMake did not find is told in a line.
# Files that it then has CMake install, and that name headers in its sources, name those that are installed: the sources
# are in no image.
set -euo pipefail

part='(.*_)?(PYTHON[0-9]*|MATLAB|OCTAVE|JAVA|(PY)?BINDINGS?|TEST(S|ING)?|EXAMPLES?|DEMOS?|SAMPLES?|TUTORIALS?'
part+='|BENCHMARKS?|DOCS?|DOCUMENTATION|DOXYGEN)(_.*)?'
source="${!#}"
otherwise() {
  local name below own
  name="$(basename "$(realpath "${source}")")"
  mapfile -t below < <(find "${source}" -mindepth 2 -maxdepth 2 -name CMakeLists.txt \
    -exec grep --files-with-matches --ignore-case --extended-regexp '^[[:space:]]*project[[:space:]]*\(' {} + |
    grep --invert-match --ignore-case --extended-regexp '/(tests?|examples?|demos?|samples?|docs?|python|benchmarks?)/[^/]*$')
  if [ "${#below[@]}" -eq 1 ]; then
    source="${below[0]%/*}"
    echo "roslab: ${name} has no CMakeLists.txt: that of its folder ${source##*/} is configured"
    return
  fi
  if [ ! -e "${source}/configure" ] && { [ -e "${source}/configure.ac" ] || [ -e "${source}/configure.in" ]; }; then
    apt-get update --quiet=2 &&
      apt-get install --yes --quiet=2 --no-install-recommends autoconf automake libtool pkg-config
    rm -rf /var/lib/apt/lists/*
    (cd "${source}" && autoreconf --force --install)
  fi
  if [ -e "${source}/configure" ]; then
    echo "roslab: ${name} has no CMakeLists.txt: its own configure is called"
    own=(sh "${source}/configure")
    if [ -x "${source}/configure" ]; then own=("${source}/configure"); fi
    "${own[@]}" --prefix=/usr/local
    exit
  fi
  if ! grep --quiet --no-messages --extended-regexp '^install[[:space:]]*:' "${source}"/{GNUm,M,m}akefile; then return; fi
  echo "roslab: ${name} has no CMakeLists.txt: its own Makefile installs it"
  cat >Makefile <<MAKEFILE
.PHONY: install
install:
	cd "$(realpath "${source}")" && env --unset=DESTDIR --unset=MAKEFLAGS install-by-make "\$\$(compile-jobs)"
MAKEFILE
  exit
}
if [ -d "${source}" ] && [ ! -e "${source}/CMakeLists.txt" ]; then
  otherwise
  set -- "${@:1:$#-1}" "${source}"
fi

# A project that writes one NAMEConfig.cmake for its build folder and for what is installed gives the folders of the first
with_installed_headers() {
  local sources prefix file
  if [ ! -e CMakeCache.txt ]; then return; fi
  sources="$(realpath "${source}" | sed 's/[][\.*^$#]/\\&/g')"
  prefix="$(sed --quiet 's/^CMAKE_INSTALL_PREFIX:[A-Z]*=//p' CMakeCache.txt)"
  while IFS='' read -r file; do
    if [[ "${file}" != "${PWD}"/* ]] || ! grep --quiet --no-messages "${sources}/include\b" "${file}"; then continue; fi
    sed --in-place "s#${sources}/include\b#${prefix}/include#g" "${file}"
    echo "roslab: ${file##*/} names the headers that are installed, not those in the sources"
  done < <(find . -name cmake_install.cmake -exec grep --no-filename --only-matching --extended-regexp '"/[^"]+\.(cmake|pc)"' {} + |
    tr --delete '"' | LC_ALL=C sort --unique)
}

log="$(mktemp)"
ended() {
  local code=$? lacking
  if [ "${code}" -eq 0 ]; then with_installed_headers || true; fi
  lacking="$(
    sed --quiet --regexp-extended \
      -e 's/.*By not providing "Find([^"]+)\.cmake".*/\1/p' \
      -e 's/.*Could NOT find ([A-Za-z0-9_]+) .*/\1/p' \
      -e "s/.*No package '([^']+)' found.*/\1/p" \
      -e "s/.*Package '([^']+)', required by '[^']*', not found.*/\1/p" \
      -e 's/.*Could not find ([A-Za-z0-9_]+) using the following (names|files):.*/\1/p' \
      <(awk '
        /^-- |^CMake .*Warning/ { error = 0 }
        /Checking for (one of the )?modules?/ { module = "" }
        /No package |, required by / { module = $0 }
        /^CMake Error/ { error = 1 }
        error
        error && /required packages? w(as|ere) not found/ { print module }' "${log}") | LC_ALL=C sort --unique
  )"
  rm -f "${log}"
  if [ "${code}" -ne 0 ] && [ -n "${lacking}" ]; then echo "roslab: CMake stops without: $(tr '\n' ' ' <<<"${lacking}")"; fi
}
trap ended EXIT

# CMake looks into the folder of ROS for what was installed of it for the library
installed_of_ros() {
  local share=/usr/local/share/roslab
  if grep --quiet --recursive --no-messages '^ros-' "${share}/required"; then return; fi
  if [ ! -r "${share}/base-packages" ]; then return 1; fi
  [ -n "$(dpkg-query --show --showformat '${Package}\n' 'ros-*' 2>/dev/null | LC_ALL=C sort |
    LC_ALL=C comm -23 - <(cut --fields=1 "${share}/base-packages" | LC_ALL=C sort))" ]
}
if installed_of_ros; then
  export CMAKE_PREFIX_PATH="/opt/ros/${ROS_DISTRO}${CMAKE_PREFIX_PATH:+:${CMAKE_PREFIX_PATH}}"
  export PKG_CONFIG_PATH="/opt/ros/${ROS_DISTRO}/lib/pkgconfig${PKG_CONFIG_PATH:+:${PKG_CONFIG_PATH}}"
fi

configure() { cmake "$@" 2>&1 | tee "${log}"; }
# Prints the programs that CMake missed
missing() {
  sed --quiet --regexp-extended \
    -e 's/.*Missing executable ([A-Za-z0-9.+-]+).*/\L\1/p' \
    -e 's/.*Could NOT find [A-Za-z0-9_]+ \(missing: *([A-Za-z0-9]+)_EXECUTABLE\b.*/\L\1/p' \
    <(awk '/^CMake .*Warning/ { error = 0 } /^CMake Error/ { error = 1 } error' "${log}") |
    sed -e 's/[.]*$//' -e '/^python/d' | sort --unique
}

status=0
configure "$@" || status=$?
if [ "${status}" -eq 0 ]; then exit; fi

# "CMake 3.13 or higher is required.  You are running version 3.10.2"
newer="$(
  sed --quiet --regexp-extended 's/.*CMake ([0-9]+(\.[0-9]+)+) or higher is required.*/\1/p' "${log}" |
    sort --version-sort | tail --lines=1
)"
# The pip of Ubuntu 16.04 and older does not see which releases are for its Python: those are bounded here
# https://github.com/pypa/pip/issues/9526
bring() {
  apt-get update --quiet=2 && apt-get install --yes --quiet=2 --no-install-recommends python3-venv || return
  echo "roslab: CMake $1 is required, and pip brings one: once more"
  python3 -m venv /opt/newer-cmake &&
    /opt/newer-cmake/bin/python -m pip install --quiet --no-cache-dir --upgrade \
      'pip<19.2; python_version < "3.5"' 'pip<21; python_version == "3.5"' 'pip; python_version >= "3.6"' &&
    /opt/newer-cmake/bin/python -m pip install --quiet --no-cache-dir "cmake>=$1,<$((${1%%.*} + 1))"
}
if [ -n "${newer}" ] && [ "$(id --user)" -eq 0 ] && bring "${newer}"; then
  PATH="/opt/newer-cmake/bin:${PATH}"
  rm -rf CMakeCache.txt CMakeFiles /var/lib/apt/lists/*
  status=0
  configure "$@" || status=$?
  if [ "${status}" -eq 0 ]; then exit; fi
fi

installed=()
mapfile -t programs < <(missing)
if [ "${#programs[@]}" -gt 0 ] && [ "$(id --user)" -eq 0 ] && apt-get update --quiet=2; then
  for program in "${programs[@]}"; do
    if apt-get install --yes --quiet=2 --no-install-recommends "${program}"; then installed+=("${program}"); fi
  done
  rm -rf /var/lib/apt/lists/*
fi
if [ "${#installed[@]}" -gt 0 ]; then
  echo "roslab: CMake misses programs, apt installs them: ${installed[*]}: once more"
  rm -rf CMakeCache.txt CMakeFiles
  status=0
  configure "$@" || status=$?
  if [ "${status}" -eq 0 ]; then exit; fi
fi

given="$(printf '%s\n' "$@" | sed --quiet --regexp-extended 's/^-D([^:=]+).*/\1/p')"
brings='[A-Z0-9_]*(INSTALL|BUILD|FETCH|DOWNLOAD|BOOTSTRAP|USE)_([A-Z0-9]+_)*(DEPS|DEPENDENC(Y|IES)|THIRD_?PARTY|EXTERNALS?|BUNDLED)'
bringing=()
while read -r name; do
  if ! grep --quiet --line-regexp --fixed-strings --regexp="${name}" <<<"${given}"; then bringing+=("-D${name}=ON"); fi
done < <(find "${source}" "${source}/.github/workflows" -maxdepth 1 -type f -size -512k \
  \( -iname 'readme*' -o -iname 'install*' -o -name '*.yml' -o -name '*.yaml' \) \
  -exec grep --no-filename --only-matching --ignore-case --extended-regexp -e "-D *${brings}(:BOOL)?=(ON|1|TRUE|YES)\b" {} + 2>/dev/null |
  sed --regexp-extended 's/^-D *([A-Za-z0-9_]+).*/\1/' | sort --unique)
# What the options install lies in /usr/local, and a library is taken from /installed alone; packages go on its list
keep_brought() {
  local lists=/installed/usr/local/share/roslab/required
  if [ ! -d /installed ]; then return; fi
  find /usr/local -cnewer "${stamp}" \( -type f -o -type l \) -print0 |
    xargs --null --no-run-if-empty cp --archive --parents --target-directory=/installed
  mkdir --parents "${lists}"
  apt-mark showmanual | LC_ALL=C sort | LC_ALL=C comm -13 "${stamp}" - >"${lists}/brought-by-$(basename "$(realpath "${source}")").txt"
}
if [ "${#bringing[@]}" -gt 0 ] && [ "$(id --user)" -eq 0 ]; then
  echo "roslab: the library's own pages have CMake bring what it needs, ${bringing[*]}: once more"
  stamp="$(mktemp)" tools="$(mktemp --directory)"
  apt-mark showmanual | LC_ALL=C sort >"${stamp}"
  # shellcheck disable=SC2016 # the words of who calls it
  if ! command -v sudo >/dev/null; then printf '#!/bin/bash\nexec env "$@"\n' | install --mode=755 /dev/stdin "${tools}/sudo"; fi
  apt-get update --quiet=2 || true # what the option calls finds no package without lists, which no layer keeps
  rm -rf CMakeCache.txt CMakeFiles
  status=0
  PATH="${tools}:${PATH}" DEBIAN_FRONTEND=noninteractive configure "${bringing[@]}" "$@" || status=$?
  rm -rf "${tools}" /var/lib/apt/lists/*
  if [ "${status}" -eq 0 ]; then keep_brought; fi
  rm -f "${stamp}"
  if [ "${status}" -eq 0 ]; then exit; fi
fi

without=()
# CMake writes down each option that it came to, also where it fails
while IFS='' read -r name; do
  if [[ "${name}" =~ ^(.*_)?(NO|NOT|WITHOUT|DISABLE|SKIP)_ ]]; then continue; fi
  if grep --quiet --line-regexp --fixed-strings --regexp="${name}" <<<"${given}"; then continue; fi
  without+=("-D${name}=OFF")
done < <(sed --quiet --regexp-extended "s/^(${part}):BOOL=(ON|1|TRUE|YES|Y)\$/\1/Ip" CMakeCache.txt)
if [ "${#without[@]}" -eq 0 ]; then exit "${status}"; fi
echo "roslab: what the library does not need is left out, ${without[*]}: once more"
rm -rf CMakeCache.txt CMakeFiles
configure "${without[@]}" "$@"
