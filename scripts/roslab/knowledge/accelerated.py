"""Python packages that compute on CUDA."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def accelerated() -> frozenset[str]:
    """Return their names, as pip, conda and ``import`` spell them."""
    return frozenset(row["name"] for row in rows("accelerated"))


@cache
def by_extra() -> frozenset[str]:
    """Return those of them that compute on the CPU unless their wheels for CUDA are asked for: ``jax[cuda12]``."""
    return frozenset(row["name"] for row in rows("accelerated") if row["by_extra"])
