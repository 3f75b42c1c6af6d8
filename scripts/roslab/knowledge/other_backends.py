"""Packages that also work with another framework than the one that they usually need."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def other_backends() -> dict[str, str]:
    """Return by normalised name the framework that such a package works with as well."""
    return {row["pip"]: row["backend"] for row in rows("other_backends")}
