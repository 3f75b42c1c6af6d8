"""Clones that a text removes again, and what it copies out of them before."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence

from roslab.evidence.dependency import GitSource
from roslab.values.dataclass import replace

_PROGRAMS = frozenset({"rm", "cp", "mv"})


def note(program: str, words: Sequence[str], sources: list[GitSource]) -> None:
    """Mark in ``sources`` the last clone of a folder that ``rm`` removes, or of which ``cp`` or ``mv`` takes a part."""
    if program not in _PROGRAMS:
        return
    paths = [posixpath.normpath(word) for word in words[1:] if not word.startswith("-")]
    for path in paths if program == "rm" else paths[:-1]:
        parts = path.split("/")
        for index in reversed(range(len(sources))):
            clone = sources[index]
            if clone.kind != "clone" or clone.removed or clone.folder not in parts:
                continue
            if parts[-1] != clone.folder:
                if program != "rm":
                    sources[index] = replace(clone, parts=(*clone.parts, parts[-1]))
            elif program == "rm":
                sources[index] = replace(clone, removed=True)
            break
