"""Other names by which CMake finds one library: its repository is called like one of them, ``abseil-cpp``."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from functools import cache

from roslab.knowledge.table import rows


def other_names(name: str) -> frozenset[str]:
    """Return the names that are of the same packages of apt as a name of CMake, without itself."""
    return frozenset(other for apt in _packages().get(name, ()) for other in _names()[apt]) - {name}


@cache
def _packages() -> Mapping[str, tuple[str, ...]]:
    found: dict[str, tuple[str, ...]] = {}
    for row in rows("cmake"):
        if row["apt"]:
            found[row["name"]] = (*found.get(row["name"], ()), row["apt"])
    return found


@cache
def _names() -> Mapping[str, list[str]]:
    found: dict[str, list[str]] = defaultdict(list)
    for name, packages in _packages().items():
        for apt in packages:
            found[apt].append(name)
    return found
