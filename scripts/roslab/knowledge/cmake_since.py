"""Calls of CMake that only later releases have: a command, a module, an option of a command."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import grouped, record
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
    return grouped((row["call"], record(Since, row, release=row["since"])) for row in rows("cmake_since"))
