"""Newer compilers than an Ubuntu's own that can be installed beside it."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import grouped
from roslab.knowledge.table import rows
from roslab.values.version import Version


@cache
def _newer() -> dict[str, tuple[tuple[str, str], ...]]:
    """Return the releases of GCC that each Ubuntu can have, oldest first, each with the PPA that has it, if any."""
    return grouped((row["ubuntu"], (row["gcc"], row["repository"])) for row in rows("newer_compilers"))


def newer_compiler(ubuntu: str, at_least: str) -> tuple[str, str] | None:
    """Return the oldest GCC of an Ubuntu that is new enough, and the PPA that has it, ``""`` for its own archive."""
    return next((each for each in _newer().get(ubuntu, ()) if Version(each[0]) >= Version(at_least)), None)
