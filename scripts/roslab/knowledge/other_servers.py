"""Ports of servers: of those that run beside a program, and of those that a program starts without saying a port."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def ports_of_others() -> frozenset[str]:
    """Return these ports: a page that names one does not tell of what its program serves."""
    return frozenset(row["port"] for row in rows("other_servers"))


@cache
def usual_ports() -> dict[str, str]:
    """Return the port of each server that a program starts, by the name that its code usually has."""
    return {row["name"]: row["port"] for row in rows("usual_ports")}
