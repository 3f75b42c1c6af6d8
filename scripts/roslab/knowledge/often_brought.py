"""What packages bring along, so that an image may have what nobody names."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.name import canonicalize_name


@cache
def often_brought() -> frozenset[str]:
    """Return the normalised names of packages that many others bring."""
    return frozenset(canonicalize_name(row["pip"]) for row in rows("often_brought"))


@cache
def brought_modules() -> dict[str, frozenset[str]]:
    """Return modules, each with the packages of which every release of today brings it, though by another package."""
    return {row["module"]: frozenset(row["pip"].split()) for row in rows("brought_modules")}


@cache
def all_brought() -> dict[str, frozenset[str]]:
    """Return the packages of which all is known that they bring in any release, and what those bring, normalised."""
    return {row["pip"]: frozenset(row["brings"].split()) for row in rows("all_brought")}


@cache
def framework_users() -> dict[str, str]:
    """Return packages of which every release of today brings a framework, with that."""
    return {row["pip"]: row["framework"] for row in rows("framework_users")}
