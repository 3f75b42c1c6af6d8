"""Packages of which pip has wheels alone, or a source that it cannot build."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def without_source() -> dict[str, frozenset[str]]:
    """Return, by their names in the table of frameworks, the releases with wheels for a Python newer than it says."""
    return {row["pip"]: frozenset(row["newer"].split()) for row in rows("without_source")}
