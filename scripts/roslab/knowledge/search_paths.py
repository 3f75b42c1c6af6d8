"""The variables that name folders in which a simulator looks for models and worlds."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def search_paths() -> frozenset[str]:
    """Return their names; each holds folders with ``:`` between them."""
    return frozenset(row["name"] for row in rows("search_paths"))
