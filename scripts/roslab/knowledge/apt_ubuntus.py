"""System packages that only some Ubuntus have, for what a page installs by apt."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import pattern


@cache
def ubuntus_of(name: str) -> frozenset[str]:
    """Return the codenames of the Ubuntus that have a package, none if the table does not tell."""
    found = next((row for row in rows("apt_ubuntus") if pattern(row["pattern"]).fullmatch(name)), None)
    return frozenset(found["ubuntus"].split()) if found else frozenset()
