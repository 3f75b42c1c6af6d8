"""The release of a framework that a release of a package is built for."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def released_with() -> dict[tuple[str, str], tuple[str, str]]:
    """Return ``(pip, release) → (framework, release)``: torchvision 0.14.1 goes with torch 1.13.1."""
    return {(row["pip"], row["release"]): (row["framework"], row["of"]) for row in rows("released_with")}
