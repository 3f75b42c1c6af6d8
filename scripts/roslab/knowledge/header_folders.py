"""Headers that a package of Ubuntu has outside the folders where a compiler looks, or that need a definition."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class HeaderFolder:
    """What the compiler must be told where code includes one of these headers."""

    headers: tuple[str, ...]
    """Whole paths, and beginnings that end with a slash."""
    folder: str
    """``""`` where it is found anyway."""
    flags: str
    found_by: frozenset[str]
    """Packages of CMake and modules of pkg-config that tell the folder."""


@cache
def header_folders() -> tuple[HeaderFolder, ...]:
    """Return all rows."""
    return tuple(
        HeaderFolder(
            headers=tuple(row["headers"].split()),
            folder=row["folder"],
            flags=row["flags"],
            found_by=frozenset(row["found_by"].split()),
        )
        for row in rows("header_folders")
    )
