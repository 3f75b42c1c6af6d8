#!/bin/bash
# usage: keep-what-runs [--skip KEYS] [FOLDER...]
# Takes out of the image what only building needs: compilers, headers and -dev packages, documentation, and packages
# that nothing that stays depends on. What stays: essential packages, ROS's core, what was installed on top of the base,
# libraries that unpackaged programs are linked with, and all that these depend on. Of what the package.xml files below
# the folders name, only what running needs: build and test dependencies go.
#   --skip KEYS  keys of rosdep that were skipped when the packages were installed, separated by spaces
set -euo pipefail

share=/usr/local/share/roslab
work="$(mktemp --directory)"
skip='' folders=()
while [ $# -gt 0 ]; do
  case "$1" in
    --skip) skip="$2" && shift ;;
    *) folders+=("$1") ;;
  esac
  shift
done
merged() { if [ -L /lib ]; then sed --regexp-extended 's#^/(bin|sbin|lib|lib32|lib64|libx32)/#/usr/\1/#'; else cat; fi; }

# Packages of keys: with -r, keys that rosdep does not know stop nothing
packages_of_keys() {
  local left=''
  if [ -s "${share}/left-out.txt" ]; then left="$(sed --quiet 's/^rosdep //p' "${share}/left-out.txt" | tr '\n' ' ')"; fi
  { rosdep install --simulate --reinstall -r --ignore-src --default-yes --rosdistro "${ROS_DISTRO}" "$@" \
    --from-paths "${folders[@]}" --skip-keys "${skip} ${left}" 2>&1 || true; } |
    sed --quiet --regexp-extended 's/.*apt-get install (.*)/\1/p' | tr ' ' '\n' | sed '/^-/d; /^$/d' | sort --unique
}

dpkg-query --show --showformat \
  '${db:Status-Abbrev}\t${Package}\t${Section}\t${Essential}\t${Priority}\t${Pre-Depends}, ${Depends}\t${Provides}\n' |
  sed --quiet 's/^i[^\t]*\t//p' >"${work}/packages"
for list in /var/lib/dpkg/info/*.list; do
  package="$(basename "${list}" .list)"
  sed "s#\$#\t${package%%:*}#" "${list}"
done | merged | sort --unique >"${work}/owners"

# What was installed on top of the base, but of rosdep's only what running needs
cut --fields=1 "${share}/base-packages" | sort --unique >"${work}/base"
apt-mark showmanual | sed 's/:.*//' | sort --unique | comm -23 - "${work}/base" >"${work}/added"
if [ "${#folders[@]}" -gt 0 ]; then
  packages_of_keys >"${work}/all-keys"
  packages_of_keys --dependency-types exec >"${work}/keys"
  comm -23 "${work}/added" "${work}/all-keys" | cat - "${work}/keys" >"${work}/wanted"
else
  cp "${work}/added" "${work}/wanted"
fi
if [ -n "${ROS_DISTRO:-}" ]; then
  printf '%s\n' ros-core "ros-${ROS_DISTRO}-ros-core" >>"${work}/wanted"
  grep --perl-regexp "^/opt/ros/${ROS_DISTRO}/setup.bash\t" "${work}/owners" | cut --fields=2 >>"${work}/wanted" || true
fi

# Libraries that programs without a package are linked with
programs() {
  find /home /opt /srv /usr/local -xdev -type f \( -perm /111 -o -name '*.so' -o -name '*.so.*' \) -size +0 -print |
    sort | comm -23 - <(cut --fields=1 "${work}/owners")
}
linked() { programs | xargs --delimiter='\n' --no-run-if-empty --max-args=100 ldd 2>/dev/null || true; }
missing() { linked | sed --quiet --regexp-extended 's/^\s*(\S+) => not found.*/\1/p' | sort --unique; }
linked | sed --quiet --regexp-extended 's/.*=> (\/[^ ]+) \(.*/\1/p' | sort --unique >"${work}/libraries"
missing >"${work}/missing-before"
{ command -v bash python3 || true; } >>"${work}/libraries"
xargs --delimiter='\n' --no-run-if-empty readlink --canonicalize <"${work}/libraries" | merged | sort --unique |
  join -t $'\t' -o 2.2 - "${work}/owners" | sort --unique >"${work}/linked"

# A closure over dependencies that does not enter what only building needs. Such a package that was asked for by name
# passes on what it depends on itself: libfoo-dev stands for libfoo.
awk -F '\t' -v wanted="${work}/wanted" -v linked="${work}/linked" '
  function building(p) {
    return name_dev(p) || section[p] ~ /(^|\/)(libdevel|doc|debug)$/ || (section[p] ~ /(^|\/)devel$/ && p !~ /^lib/)
  }
  function name_dev(p) { return p ~ /-(dev|doc|dbg|dbgsym)(-[0-9.-]+)?$/ }
  function keep(p) { if ((p in section) && !(p in kept)) { kept[p] = 1; queue[++last] = p } }
  function keep_dependencies(p,   n, i, m, j, names, choices, q) {
    n = split(depends[p], names, ",")
    for (i = 1; i <= n; i++) {
      m = split(names[i], choices, "|")
      for (j = 1; j <= m; j++) {
        q = choices[j]; gsub(/\(.*\)|:[a-z0-9]+|[ \t]/, "", q)
        if (q in section) { if (!building(q)) keep(q) }
        else if (q in provider) { if (!building(provider[q])) keep(provider[q]) }
      }
    }
  }
  { section[$1] = $2; depends[$1] = $5; n = split($6, given, ",")
    for (i = 1; i <= n; i++) { gsub(/\(.*\)|[ \t]/, "", given[i]); if (given[i] != "") provider[given[i]] = $1 }
    if ($3 == "yes" || $4 == "required" || $4 == "important") essential[$1] = 1 }
  END {
    for (p in essential) keep(p)
    while ((getline p <linked) > 0) keep(p)
    while ((getline p <wanted) > 0) { if (building(p)) keep_dependencies(p); else keep(p) }
    keep("ca-certificates")
    for (at = 1; at <= last; at++) keep_dependencies(queue[at])
    for (p in section) if (!(p in kept)) print p
  }' "${work}/packages" | sort >"${work}/unneeded"
DEBIAN_FRONTEND=noninteractive xargs --no-run-if-empty \
  dpkg --purge --force-depends --force-unsafe-io <"${work}/unneeded" >/dev/null 2>"${work}/log" ||
  { cat "${work}/log" && exit 1; }

rm -rf /usr/include /usr/local/include /opt/ros/*/include /usr/share/{info,locale,man,gtk-doc,help,lintian} \
  /var/lib/apt/lists/* /var/cache/{apt,debconf,ldconfig,man}/* /var/log/{apt/[!h]*,alternatives.log,dpkg.log} /root/.[a-z]*/
find /usr/share/doc -type f ! -name copyright -delete
find /usr/share/doc -type l -delete
find /usr/share/doc -mindepth 1 -type d -empty -delete
find /usr/lib /usr/local/lib -xdev -name '*.a' -delete
find /var/lib/dpkg -name '*-old' -delete
find /tmp /var/tmp -mindepth 1 -maxdepth 1 ! -path "${work}" -exec rm -rf {} +

if lost="$(missing | comm -13 "${work}/missing-before" -)" && [ -n "${lost}" ]; then
  echo "roslab: libraries that programs are linked with were taken out: ${lost//$'\n'/ }" >&2
  exit 1
fi
echo "roslab: $(wc --lines <"${work}/unneeded") packages that only building needs were taken out"
rm -rf "${work}"

# An image that starts from nothing has no variables of its base: the entry point sets those that nobody has set
file="${share}/base-environment.bash"
own=' DEBIAN_FRONTEND HOME HOSTNAME OLDPWD PATH PWD SHLVL SOURCE_DATE_EPOCH _ '
env --null | sort --zero-terminated | while IFS='=' read -r -d '' name value; do
  if [[ "${own}" = *" ${name} "* || "${name,,}" = *_proxy || ! "${name}" =~ ^[A-Za-z_][A-Za-z0-9_]*$ ]]; then continue; fi
  # shellcheck disable=SC2016 # read by the shell that sources the file
  printf 'if [ -z "${%s+set}" ]; then export %s=%q; fi\n' "${name}" "${name}" "${value}"
done >"${file}"
# shellcheck disable=SC2016 # the same
printf 'if [[ ":${PATH}:" != *:%q:* ]]; then PATH="${PATH}":%q; fi\n' "${PATH}" "${PATH}" >>"${file}"
touch "${share}/environment.bash"
sed --in-place "1i source ${file}" "${share}/environment.bash"
if [ ! -s "${share}/environment.bash" ]; then echo "source ${file}" >"${share}/environment.bash"; fi
if ! grep --quiet --fixed-strings "${share}/environment.bash" /etc/bash.bashrc; then
  echo "source ${share}/environment.bash" >>/etc/bash.bashrc
fi
