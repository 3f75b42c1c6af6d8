"""Packages that give an older Python a module of a newer one."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.version import Version


@cache
def backports() -> dict[str, Version]:
    """Return the first Python that has the module itself, by the normalised name of the package."""
    return {row["pip"]: Version(row["since"]) for row in rows("backports")}
