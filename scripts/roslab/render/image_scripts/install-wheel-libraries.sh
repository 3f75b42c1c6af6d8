#!/bin/bash
# usage: install-wheel-libraries PYTHON
# Installs the system's libraries that the modules of a Python are linked with and do not bring: a wheel may take those of
# X11, OpenGL and GLib for granted (PEP 513), and many take more. The package of a library has its name by Debian's rule
# (https://www.debian.org/doc/debian-policy/ch-sharedlibs.html#run-time-shared-libraries) or by shared-objects.txt, which
# also says what comes from elsewhere (NAME* -). What apt does not know is left out. Libraries of a package that no module of
# it is linked with may be plugins that nothing loads: they bring nothing.
set -euo pipefail

table=/usr/local/share/roslab/shared-objects.txt
work="$(mktemp --directory)"
# Without the distribution's own packages, for which apt has brought everything
"$1" -c 'import sys; print("\n".join([p for p in sys.path if p.endswith("-packages") and not p.startswith("/usr/lib/")]))' \
  >"${work}/folders"
echo /opt/cloned >>"${work}/folders" # what was cloned and is installed editable
while read -r folder; do
  if [ -d "${folder}" ]; then find "${folder}" ! -type d -regextype posix-extended -regex '.*\.so(\.[0-9.]+)?' -print; fi
done <"${work}/folders" >"${work}/files"
sed --quiet --regexp-extended '/\.so$/{\#/lib[^/]*$#!p}' "${work}/files" >"${work}/modules"
if [ ! -s "${work}/modules" ]; then rm -rf "${work}" && exit; fi

# A package may load a library of another package before its own
{
  sed 's#.*/##' "${work}/files"
  find "$("$1" -c 'import sys; print(sys.prefix)')/lib" -maxdepth 1 -name '*.so*' -printf '%f\n' 2>/dev/null || true
} | sort --unique >"${work}/brought"
{ xargs --delimiter='\n' --max-args=50 --max-procs="$(nproc)" ldd <"${work}/modules" 2>/dev/null || true; } |
  sed --quiet --regexp-extended 's/^\s*(lib[^ /]+\.so[^ /]*) => not found.*/\1/p' | sort --unique |
  comm -23 - "${work}/brought" >"${work}/missing"

packages=()
while read -r library; do
  known="$(awk -v library="${library}" '
    $1 == library { found = $2 }
    /[*] -$/ && !found && index(library, substr($1, 1, length($1) - 1)) == 1 { found = $2 }
    END { print found }' "${table}")"
  if [ "${known}" = - ]; then continue; fi
  name="${library%%.so*}" number="${library#*.so}"
  name="${name,,}" name="${name//_/-}" number="${number#.}"
  if [[ "${name}" =~ [0-9]$ && -n "${number}" ]]; then name+=-; fi
  packages+=("${known:-${name}${number}}")
  echo "roslab: Python packages are linked with ${library}, which is not there: ${packages[-1]}"
done <"${work}/missing"
rm -rf "${work}"
if [ "${#packages[@]}" -gt 0 ]; then install-optional-apt "${packages[@]}"; fi
