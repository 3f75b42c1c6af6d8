#!/bin/bash
# usage: install-rosdep-keys [--tables TAG] [--skip KEYS] [--complete] [--want PACKAGES] [--before DAY] [--required] FOLDER...
# Installs what the package.xml files below the folders name. Keys that rosdep does not know, or whose packages apt does
# not have, are named and left out.
#   --tables TAG     use the tables of ros/rosdistro at this tag: newer ones forget a distro some years after its end;
#                    where they do not answer, the base's own are used
#   --skip KEYS      keys to install nothing for, separated by spaces
#   --complete       what repositories that were cloned to the last folder ask for, and nothing has, is cloned there too
#   --want PACKAGES  with --complete: so is what CMake or launch files need and no package.xml names, separated by spaces
#   --before DAY     as of this day (YYYY-MM-DD)
#   --required       what CMake of what was cloned to the last folder requires is installed, too
set -euo pipefail

left_out=/usr/local/share/roslab/left-out.txt
sources=/etc/ros/rosdep/sources.list.d
tag='' skip='' complete='' completed='' want='' required='' day='' folders=()
while [ $# -gt 0 ]; do
  case "$1" in
    --tables) tag="$2" && shift ;;
    --skip) skip="$2" && shift ;;
    --complete) complete=yes ;;
    --want) want="$2" && shift ;;
    --before) day="$2" && shift ;;
    --required) required=yes ;;
    *) folders+=("$1") ;;
  esac
  shift
done

# A line that names nothing is a key that rosdep cannot find, and one with several names, or with words in
# parentheses, is one key
find "${folders[@]}" -name package.xml -exec sed --in-place --regexp-extended \
  -e 's#<([a-z_]*depend)( [^>]*)?>[[:space:]]*</\1>##g' \
  -e ':version' -e 's#<([a-z_]*depend)( [^>]*)?>([^<(]*[^<([:space:]])[[:space:]]*\([^()<]*\)#<\1\2>\3#g' -e 't version' \
  -e ':several' \
  -e 's#<([a-z_]*depend)( [^>]*)?>[[:space:]]*([^<[:space:]]+)[[:space:]]+([^<[:space:]][^<]*)</\1>#<\1\2>\3</\1><\1\2>\4</\1>#' \
  -e 't several' {} +

update() { rosdep update --rosdistro "${ROS_DISTRO}"; }

use_tables() {
  local tables="https://raw.githubusercontent.com/ros/rosdistro/${tag}" kept_index="${ROSDISTRO_INDEX_URL:-}"
  mkdir --parents "${sources}" /tmp/own-tables
  find "${sources}" -name '*.list' -exec mv --target-directory=/tmp/own-tables {} +
  printf 'yaml %s\n' "${tables}/rosdep/"{base,python,ruby}.yaml >"${sources}/20-default.list"
  export ROSDISTRO_INDEX_URL="${tables}/index-v4.yaml"
  if update; then return; fi
  echo "roslab: the tables of rosdistro ${tag} do not answer: the base's own are used"
  rm "${sources}/20-default.list"
  find /tmp/own-tables -name '*.list' -exec mv --target-directory="${sources}" {} +
  if [ -n "${kept_index}" ]; then export ROSDISTRO_INDEX_URL="${kept_index}"; else unset ROSDISTRO_INDEX_URL; fi
  update
}

# rosdep takes a manifest.xml, which other frameworks write too, in place of the package.xml beside it
hide_manifests() {
  find "${folders[@]}" -name manifest.xml -execdir test -f package.xml \; -execdir mv manifest.xml manifest.xml.hidden \;
}

install_keys() {
  hide_manifests
  rosdep install "$@" --ignore-src --rosdistro "${ROS_DISTRO}" --from-paths "${folders[@]}" --skip-keys "${skip}"
}

# rosdep calls apt for each package anew, which reads what is installed and runs the same triggers each time. Where apt
# does not take all of them together, and for what apt does not install, rosdep does as ever; also where it cannot tell
# what it would do, as it cannot of pip before a key has brought that.
install_together() {
  local commands line words together=() rest=''
  commands="$(install_keys --simulate --default-yes 2>/dev/null)" || commands=untold
  while read -r line; do
    case "${line}" in
      'apt-get install -y '*) read -r -a words <<<"${line#apt-get install -y }" && together+=("${words[@]}") ;;
      '' | '#'*) ;;
      *) rest=yes ;;
    esac
  done <<<"${commands}"
  if [ "${#together[@]}" -gt 0 ] && ! apt-get install -y "${together[@]}"; then
    echo "roslab: apt does not take these packages together: each is installed for itself"
    rest=yes
  fi
  if [ -n "${rest}" ]; then install_keys --default-yes; fi
}

unknown_keys() {
  { install_keys --simulate --reinstall 2>&1 || true; } |
    sed --quiet --regexp-extended 's/.*definition (for|of) \[([^]]+)\].*/\2/p' | sort --unique
}

# Prints the keys whose packages the sources of apt do not have, for their rule names none for this Ubuntu
absent_keys() {
  local keys key='' line package
  mapfile -t keys < <(rosdep keys --ignore-src --rosdistro "${ROS_DISTRO}" --from-paths "${folders[@]}" 2>/dev/null |
    grep --invert-match --line-regexp --fixed-strings --file=<(tr ' ' '\n' <<<"${skip}" | grep .))
  if [ "${#keys[@]}" -eq 0 ]; then return; fi
  while read -r line; do
    case "${line}" in
      '#ROSDEP['*) key="${line#*[}" && key="${key%]}" ;;
      '#apt') read -r line && for package in ${line}; do
        if apt-cache show "${package}" >/dev/null 2>&1; then continue; fi
        if ! apt-get install --simulate "${package}" >/dev/null 2>&1; then echo "${key}" && break; fi
      done ;;
    esac
  done < <(rosdep resolve "${keys[@]}" "${keys[0]}" 2>/dev/null) | sort --unique # one alone has no line of its own
}

# rosdep calls apt several times, and each call would read all the lists anew: Docker's bases keep no cache of them
caches=/etc/apt/apt.conf.d/zz-roslab-caches
printf 'Dir::Cache::%s "/tmp/apt-%s.bin";\n' pkgcache pkgcache srcpkgcache srcpkgcache >"${caches}"
# What apt and rosdep download, at the same time
lists=/tmp/apt-update
apt-get update >"${lists}" 2>&1 &
updating=$!
if [ -n "${tag}" ]; then
  use_tables
else
  if ! ls "${sources}"/*.list >/dev/null 2>&1; then rosdep init; fi
  update
fi
if ! wait "${updating}"; then cat "${lists}" >&2 && exit 1; fi
cat "${lists}" && rm "${lists}"
clone_unknown() { clone-unknown --before "${day}" --want "${want}" "${folders[0]}" "${folders[-1]}" "$@"; }
if [ -n "${want}" ]; then
  read -r -a keys <<<"${want}"
  if clone_unknown "${keys[@]}"; then completed=yes; fi
fi
# Nothing is installed where rosdep does not know a key, and that is the time to ask which: it tells of one a package at
# a time, so until there is none that was not told before
said=/tmp/rosdep-install
if install_together 2>"${said}"; then
  cat "${said}" >&2
else
  before='' asked="${skip}"
  while unknown="$(unknown_keys)" && [ "${unknown}" != "${before}" ]; do
    mapfile -t keys <<<"${unknown}"
    if [ -n "${complete}" ] && clone_unknown "${keys[@]}"; then
      completed=yes
      continue
    fi
    before="${unknown}"
    for key in ${unknown}; do
      echo "rosdep ${key}" >>"${left_out}"
      skip="${skip} ${key}"
    done
  done
  for key in $(absent_keys); do
    echo "rosdep ${key}" >>"${left_out}"
    skip="${skip} ${key}"
  done
  if [ "${skip}" = "${asked}" ] && [ -z "${completed}" ]; then cat "${said}" >&2 && exit 1; fi
  if [ -s "${left_out}" ]; then sed 's/^/roslab: left out: /' "${left_out}"; fi
  install_together
fi
find "${folders[@]}" -name manifest.xml.hidden -execdir mv manifest.xml.hidden manifest.xml \;
# CMake of what is cloned may require more than its package.xml names
if [ -n "${required}" ]; then
  mapfile -t more < <(required-components "${folders[-1]}")
  if [ "${#more[@]}" -gt 0 ]; then install-optional-apt "${more[@]}"; fi
fi
rm "${said}" "${caches}"
# The next step that installs by these lists need not read all of them again
if grep --quiet ' /var/lib/apt/lists ' /proc/mounts && [ -e /tmp/apt-srcpkgcache.bin ]; then
  cp /tmp/apt-srcpkgcache.bin /var/lib/apt/lists/roslab-cache.part
  mv /var/lib/apt/lists/roslab-cache.part /var/lib/apt/lists/roslab-cache.bin
fi
rm -f /tmp/apt-*.bin
rm -rf /var/cache/{apt/*.bin,ldconfig/aux-cache} /var/log/{apt/[!h]*,alternatives.log,dpkg.log}
find /var/log/apt -name history.log -exec sed --in-place '/-Date: /d' {} +
