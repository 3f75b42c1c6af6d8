"""Names of systems other than Ubuntu, as in the names of lists and folders for these: ``deps_macos.repos``."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def other_systems() -> frozenset[str]:
    """Return the names of systems that are no Linux."""
    return frozenset(row["name"] for row in rows("system_names") if not row["linux"])


@cache
def other_linuxes() -> frozenset[str]:
    """Return the names of other distributions of Linux, to which a release may be added: ``debian12``."""
    return frozenset(row["name"] for row in rows("system_names") if row["linux"])
