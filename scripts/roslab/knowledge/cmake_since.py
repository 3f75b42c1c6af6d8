"""Calls of CMake that only later releases have: a command, a module, an option of a command."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Since:
    """The first release that has something."""

    words: tuple[str, ...]
    """Words that stand together in the call; none where every call of the command counts."""
    release: str


@cache
def since() -> dict[str, tuple[Since, ...]]:
    """Return the table by the name of the command, in lower case."""
    found: dict[str, tuple[Since, ...]] = {}
    for row in rows("cmake_since"):
        each = Since(words=tuple(row["words"].split()), release=row["since"])
        found[row["call"]] = (*found.get(row["call"], ()), each)
    return found
