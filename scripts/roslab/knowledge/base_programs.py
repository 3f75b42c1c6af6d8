"""Programs that every image has: those of Ubuntu's essential packages, and of those that every image installs."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def base_programs() -> frozenset[str]:
    """Return their names."""
    return frozenset(name for row in rows("base_programs") for name in row["programs"].split())
