#!/bin/bash
# usage: wheels-of [LIST]
# Without LIST, brings a pip that can ask its index.
# Prints for each line of LIST, NAME RELEASE PYTHON..., the name and each of these Pythons for which the index has a wheel of the
# release on this machine's kind of processor.
set -euo pipefail

if [ $# -eq 0 ]; then
  if ! python3 -m pip --version; then
    apt-get update
    apt-get install --yes --no-install-recommends python3-pip
  fi
  python3 -m pip install --target /tmp/asking pip
  exit
fi
platforms=()
for tag in manylinux1 manylinux2010 manylinux2014 manylinux_2_{5,12,17,24,26,27,28,31}; do
  platforms+=(--platform "${tag}_$(uname -m)")
done
while read -r name release pythons; do
  for python in ${pythons}; do
    listed="$(PYTHONPATH=/tmp/asking python3 -m pip index versions "${name}" --python-version "${python}" --implementation cp \
      --only-binary :all: "${platforms[@]}" </dev/null | sed --quiet 's/^Available versions: //p' | tr -d ' ' | tr , '\n' || true)"
    if grep --quiet --line-regexp --fixed-strings -e "${release}" <<<"${listed}"; then echo "${name} ${python}"; fi
  done
done <"$1"
