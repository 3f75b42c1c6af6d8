"""Packages that many others bring along, so that an image may have one which nobody names."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.name import canonicalize_name


@cache
def often_brought() -> frozenset[str]:
    """Return their normalised names."""
    return frozenset(canonicalize_name(row["pip"]) for row in rows("often_brought"))
