"""Modules of which the index's package of the same name is known to be another thing, or is the authors' own file."""

from __future__ import annotations

from fnmatch import fnmatchcase
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.name import canonicalize_name


@cache
def never_by_name(module: str) -> bool:
    """Tell whether a module is never to be sought under its own name: ``utils`` and ``yarp`` are others' there."""
    name = canonicalize_name(module)
    return any(fnmatchcase(name, pattern) for pattern in _patterns())


@cache
def widespread_stems() -> frozenset[str]:
    """Return beginnings of names that packages of many authors share: ``torch``, ``flask``."""
    return frozenset(row["stem"] for row in rows("widespread_stems"))


@cache
def _patterns() -> tuple[str, ...]:
    return tuple(canonicalize_name(row["module"]) for row in rows("never_by_name"))
