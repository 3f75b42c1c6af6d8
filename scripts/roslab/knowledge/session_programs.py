"""Programs of scripts that start something in several terminals: they open these, or the script goes wrong without."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def terminals() -> frozenset[str]:
    """Return the programs that keep or open terminals."""
    return frozenset(row["program"] for row in rows("programs") if row["session"] == "terminals")


@cache
def session_programs() -> frozenset[str]:
    """Return them and the small programs without which such a script goes wrong: no image has them of itself."""
    return frozenset(row["program"] for row in rows("programs") if row["session"])
