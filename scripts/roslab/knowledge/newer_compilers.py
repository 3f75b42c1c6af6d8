"""Newer compilers than an Ubuntu's own that can be installed beside it."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import grouped
from roslab.knowledge.table import rows
from roslab.values.version import Version


@cache
def _newer() -> dict[str, tuple[tuple[str, str], ...]]:
    """Return the releases of GCC that each Ubuntu can have, each with the PPA that has it, if any."""
    return grouped((row["ubuntu"], (row["gcc"], row["repository"])) for row in rows("newer_compilers"))


def newer_compiler(ubuntu: str, at_least: str) -> str | None:
    """Return the oldest GCC that an Ubuntu can have and that is new enough."""
    fitting = (gcc for gcc, _ in _newer().get(ubuntu, ()) if Version(gcc) >= Version(at_least))
    return min(fitting, key=Version, default=None)


def repository_of(ubuntu: str, version: str) -> str | None:
    """Return the PPA that has a GCC for an Ubuntu, ``""`` where it is in the archive, ``None`` where none is known."""
    return dict(_newer().get(ubuntu, ())).get(version)
