"""Packages of ROS 2 that are headers alone: code compiles with them once the compiler finds their folder."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class HeaderOnly:
    """A package whose headers lie in a folder of their own (``include/tf2/tf2/…``) from a distribution on."""

    package: str
    includes: tuple[str, ...]
    """Further packages whose headers its own include."""
    since: str
    """The first distribution of which that is so."""


@cache
def header_only() -> tuple[HeaderOnly, ...]:
    """Return all rows."""
    return tuple(
        HeaderOnly(package=row["package"], includes=tuple(row["with"].split()), since=row["since"])
        for row in rows("header_only")
    )
