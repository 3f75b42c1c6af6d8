"""Archives that a page or a script fetches, of libraries that the image has anyway: by apt, or by the tree's CMake."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping

from roslab.decide.ros.source_names import plain
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

_ARCHIVE = pattern(
    r"(?:wget|curl)\s+(?:\S+/)?(?:lib)?(?P<name>[a-z][a-z+_-]*?)"
    r"(?P<version>[-_.]?v?\d+(?:[._-]\d+)*(?:[._-]?(?:a|alpha|b|beta|p|rc)\d*)?)?"
    r"(?:[._-](?:library|sources?|src))?\.(?:tar(?:\.\w+)?|tgz|zip)",
    re.IGNORECASE,
)
"""A library's name, and after it nothing but a version: ``opencv_contrib-3.4.6.zip`` is not OpenCV's."""
_DEV = pattern(r"(?:lib)?([a-z][a-z+-]*?)(?:-?\d[\d.]*[a-z]?)?(?:-all)?-dev")
_INTERPRETERS = frozenset({"python"})
"""An archive is of another one than apt's, which stays beside it: a page that fetches one means that."""
SHORTEST = 3


def libraries(evidence: Evidence, apt: Collection[str]) -> Mapping[str, str]:
    """Return the names of libraries, without ``lib`` and numbers, each with the package of apt that brings it.

    ``""`` for one that CMake fetches: there the tree itself says which release it is.
    """
    found = {plain(match[1]): name for name in sorted(apt) if (match := _DEV.fullmatch(name))}
    fetched = (source.name for project in evidence.cmake for source in project.sources)
    found |= dict.fromkeys((plain(name).rstrip("0123456789") for name in fetched), "")
    return {name: by for name, by in found.items() if len(name) >= SHORTEST and name not in _INTERPRETERS}


def in_its_place(step: str, libraries: Mapping[str, str]) -> str | None:
    """Return what the image has in place of the archive that a step fetches, ``None`` for nothing.

    ``""``: just what is fetched, as nothing says which release it is; else the package of apt, which has its own.
    """
    match = _ARCHIVE.fullmatch(step)
    by = libraries.get(plain(match["name"])) if match else None
    return by if by is None or (match and match["version"]) else ""
