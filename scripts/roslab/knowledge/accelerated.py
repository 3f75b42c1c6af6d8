"""Python packages that compute on CUDA."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def accelerated() -> frozenset[str]:
    """Return their names, as pip, conda and ``import`` spell them."""
    return frozenset(row["name"] for row in rows("accelerated"))
