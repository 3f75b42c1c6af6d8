#!/bin/bash
# usage: listed-repositories FOLDER LEAST MOST
# Prints NAME URL REF of what the lists below a folder name (.rosinstall, .repos), from LEAST to MOST folders deep: REF is a tag, a
# commit or a branch, or nothing. The interpreter of rosdep can read YAML.
set -euo pipefail

find "$1" -mindepth "$2" -maxdepth "$3" -name .git -prune -o \( -name '*.rosinstall' -o -name '*.repos' \) -print0 |
  LC_ALL=C sort --zero-terminated |
  xargs --null --no-run-if-empty "$(sed --quiet '1s/^#! *//p' "$(command -v rosdep)")" -c '
import sys, yaml
for path in sys.argv[1:]:
    try:
        with open(path) as file:
            data = yaml.safe_load(file)
    except Exception:
        continue
    rows = []
    if isinstance(data, list):
        rows = [(row["git"].get("local-name"), row["git"]) for row in data if isinstance(row, dict) and isinstance(row.get("git"), dict)]
    elif isinstance(data, dict) and isinstance(data.get("repositories"), dict):
        rows = [(name, row) for name, row in data["repositories"].items() if isinstance(row, dict)]
    for name, row in rows:
        url = str(row.get("uri") or row.get("url") or "")
        name = str(name or "").rstrip("/").rpartition("/")[2]
        if name and url and not set(name + url) & set(" \t\n"):
            print("%s %s %s" % (name, url, row.get("version") or ""))
'
