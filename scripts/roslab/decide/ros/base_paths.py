"""Folders in which pages have colcon look for packages: it finds those inside another package nowhere else."""

from __future__ import annotations

import posixpath

from roslab.evidence.facts import Evidence

BASE_PATHS = "--base-paths"


def base_paths(evidence: Evidence) -> tuple[str, ...]:
    """Return the names of the folders, each as the last part of a path, that calls of colcon on pages give it."""
    found: dict[str, None] = {}
    for mention in evidence.mentions:
        if mention.topic == "build_tool" and mention.source == "readme" and BASE_PATHS in mention.text:
            given = False
            for word in mention.text.replace(f"{BASE_PATHS}=", f"{BASE_PATHS} ").split():
                given = word == BASE_PATHS or (given and not word.startswith("-"))
                if given and word != BASE_PATHS:
                    found.setdefault(posixpath.basename(word.strip("\"'`").rstrip("/")))
    return tuple(name for name in found if name)
