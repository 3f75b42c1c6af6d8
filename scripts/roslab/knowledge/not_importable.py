"""Packages that install where they cannot be imported: on a newer Python, or without a display."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.version import Version


@cache
def importable_below() -> dict[str, Version]:
    """Return the first Python on which that is so, by the normalised name of the package."""
    return {row["pip"]: Version(row["since_python"]) for row in rows("not_importable")}


@cache
def importable_with_display() -> frozenset[str]:
    """Return the normalised names of packages whose import looks for a display and stops without one."""
    return frozenset(row["pip"] for row in rows("importable_with_display"))
