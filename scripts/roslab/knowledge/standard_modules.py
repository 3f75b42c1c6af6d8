"""Modules of Python's own library that not every Python has: dropped, renamed, or newer than the oldest one."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def standard_modules() -> frozenset[str]:
    """Return their names; with them a plan is the same whichever Python makes it."""
    return frozenset(row["module"] for row in rows("standard_modules"))


@cache
def of_python_2() -> frozenset[str]:
    """Return those that Python 3 calls otherwise and whose names nothing else has: code with them is for Python 2."""
    return frozenset(row["module"] for row in rows("standard_modules") if row["shows_python_2"])
