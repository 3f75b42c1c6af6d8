"""Clones that a page compiles and does not install: it has CMake find them in the folder in which they were built.

https://cmake.org/cmake/help/latest/command/find_package.html, ``<PackageName>_DIR``, 2026-11-28.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Sequence

from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Mention
from roslab.evidence.prose.checkouts import clone_at
from roslab.values.dataclass import replace


def with_found(words: Sequence[str], sources: Sequence[GitSource], mentions: Iterable[Mention]) -> list[GitSource]:
    """Return the clones of a text, with those installed that a call of CMake finds where they were built.

    ``-DNAME_DIR=…/NAME/build`` names the folder. ``mentions`` tell the options with which CMake was called there
    before; what these name by a path lies on the author's computer.
    """
    found = list(sources)
    for word in words:
        option, _, path = word.partition("=")
        parts = path.strip("\"'").split("/")
        at = next((index for index, part in enumerate(parts) if index and part.startswith("build")), 0)
        if not (at and option.startswith("-D") and option.partition(":")[0].endswith("_DIR")):
            continue
        clone = clone_at(parts[at - 1 : at], found)
        if clone is None or found[clone].installed or found[clone].kind != "clone":
            continue
        said = (m.text for m in mentions if m.topic == "compiled" and posixpath.basename(m.value) == parts[at - 1])
        options = " ".join(each for each in next(said, "").split() if each.startswith("-D") and "/" not in each)
        found[clone] = replace(found[clone], installed=True, configured=True, options=options)
    return found
