"""Modules of MicroPython, which microcontrollers run: pip has none of them."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def micropython_modules() -> dict[str, bool]:
    """Return them, each with whether it tells by itself that code is for a microcontroller."""
    return {row["module"]: row["alone"] == "yes" for row in rows("micropython_modules")}
