#!/bin/bash
# usage: listed-repositories FOLDER LEAST MOST
# Prints NAME URL REF of what the lists below a folder name (.rosinstall, .repos, gitman.yml, those of treep_*), from LEAST to MOST folders
# deep: REF is a tag, a commit or a branch, or nothing. Of gitman's groups it is the default one, at the commits that are locked. The
# interpreter of rosdep can read YAML.
set -euo pipefail

find "$1" -mindepth "$2" -maxdepth "$3" -name .git -prune -o \( -name '*.rosinstall' -o -name '*.repos' -o -name gitman.yml -o -name .gitman.yml \
  -o -path '*/treep_*/repositories*.yaml' \) -print0 |
  LC_ALL=C sort --zero-terminated |
  xargs --null --no-run-if-empty "$(sed --quiet '1s/^#! *//p' "$(command -v rosdep)")" -c '
import os, sys, yaml
def of_treep(path, data):
    # An origin is an address, or a prefix of them that configuration.yaml beside the list has
    try:
        with open(os.path.join(os.path.dirname(path), "configuration.yaml")) as file:
            prefixes = yaml.safe_load(file)["origin_prefixes"]
    except Exception:
        prefixes = {}
    prefixes = prefixes if isinstance(prefixes, dict) else {}
    for name, row in data.items():
        origin = str(row.get("origin") or "") if isinstance(row, dict) else ""
        if origin in prefixes:
            origin = "%s%s.git" % (prefixes[origin], name)
        if ":" in origin:
            yield name, {"url": origin, "version": row.get("commit") or row.get("tag") or row.get("branch")}
for path in sys.argv[1:]:
    try:
        with open(path) as file:
            data = yaml.safe_load(file)
    except Exception:
        continue
    rows = []
    if isinstance(data, list):
        rows = [(row["git"].get("local-name"), row["git"]) for row in data if isinstance(row, dict) and isinstance(row.get("git"), dict)]
    elif isinstance(data, dict) and path.endswith(".yaml"):
        rows = list(of_treep(path, data))
    elif isinstance(data, dict) and isinstance(data.get("repositories"), dict):
        rows = [(name, row) for name, row in data["repositories"].items() if isinstance(row, dict)]
    elif isinstance(data, dict) and isinstance(data.get("sources"), list):
        def folder(row):
            last = str(row.get("repo") or "").rstrip("/").rpartition("/")[2]
            return str(row.get("name") or (last[:-4] if last.endswith(".git") else last))
        def listed(key):
            entries = data.get(key) if isinstance(data.get(key), list) else []
            return [(folder(row), row) for row in entries if isinstance(row, dict) and row.get("type", "git") == "git"]
        groups = data.get("groups") if isinstance(data.get("groups"), list) else []
        groups = {row.get("name"): row.get("members") for row in groups if isinstance(row, dict) and isinstance(row.get("name"), str)}
        wanted, left = set(), [data.get("default_group")]
        while left:
            name = left.pop()
            members = groups.pop(name, None) if isinstance(name, str) else None
            left += members if isinstance(members, list) else []
            wanted.add(name if isinstance(name, str) else "")
        locked = {name: row.get("rev") for name, row in listed("sources_locked")}
        rows = [
            (name, {"url": row.get("repo"), "version": locked.get(name) or row.get("rev")})
            for name, row in listed("sources") if name in wanted or not data.get("default_group")
        ]
    for name, row in rows:
        url = str(row.get("uri") or row.get("url") or "")
        name = str(name or "").rstrip("/").rpartition("/")[2]
        if name and url and not set(name + url) & set(" \t\n"):
            print("%s %s %s" % (name, url, row.get("version") or ""))
'
