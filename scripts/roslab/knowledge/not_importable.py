"""Packages that install on a Python on which their last release cannot be imported."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.version import Version


@cache
def importable_below() -> dict[str, Version]:
    """Return the first Python on which that is so, by the normalised name of the package."""
    return {row["pip"]: Version(row["since_python"]) for row in rows("not_importable")}
