"""Modules of Python's own library that not every Python has: dropped, renamed, or newer than the oldest one."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def standard_modules() -> frozenset[str]:
    """Return their names; with them a plan is the same whichever Python makes it."""
    return frozenset(row["module"] for row in rows("standard_modules"))
