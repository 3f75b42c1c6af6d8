"""Servers that run beside a program, by the ports that they listen at."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def ports_of_others() -> frozenset[str]:
    """Return these ports: a page that names one does not tell of what its program serves."""
    return frozenset(row["port"] for row in rows("other_servers"))
