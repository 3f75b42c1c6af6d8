"""Archives that a page or a script fetches, of libraries that the image has anyway: by apt, or by the tree's CMake."""

from __future__ import annotations

import re
from collections.abc import Collection

from roslab.decide.ros.source_names import plain
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

_ARCHIVE = pattern(r"(?:wget|curl)\s+\S+\.(?:tar(?:\.\w+)?|tgz|zip)$")
_DEV = pattern(r"(?:lib)?([a-z][a-z+]*?)\d*(?:[.-].*)?-dev")
_WORD = pattern(r"[A-Za-z][A-Za-z+]*")
SHORTEST = 3
UNKNOWN = "…"
"""In the place of a value that nobody knows."""


def libraries(evidence: Evidence, apt: Collection[str]) -> frozenset[str]:
    """Return the names of libraries that packages of apt bring, or that CMake fetches, without ``lib`` and numbers."""
    found = {match[1] for name in apt if (match := _DEV.fullmatch(name))}
    fetched = (source.name for project in evidence.cmake for source in project.sources)
    found |= {plain(name).rstrip("0123456789") for name in fetched}
    return frozenset(name for name in found if len(name) >= SHORTEST)


def is_there(step: str, libraries: Collection[str]) -> bool:
    """Tell whether a step only fetches the archive of one of these libraries: ``wget https://…/gmp-6.3.0.tar.xz``.

    Of an archive whose name nobody knows the words before it tell: ``https://boostorg.example/source/….tar.gz``.
    """
    if not _ARCHIVE.fullmatch(step):
        return False
    folders, _, file = step.rpartition("/")
    if UNKNOWN not in file:
        first = _WORD.match(file)
        return first is not None and plain(first[0]).removeprefix("lib") in libraries
    words = {plain(word) for word in re.split(r"[/.:_-]", folders)}
    return any(word in {name, f"{name}org"} for word in words for name in libraries)
