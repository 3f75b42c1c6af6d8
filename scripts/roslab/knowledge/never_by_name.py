"""Modules of which the index's package of the same name is known to be another thing, or is the authors' own file."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.name import canonicalize_name
from roslab.values.pattern import named_by


@cache
def never_by_name(module: str) -> bool:
    """Tell whether a module is never to be sought under its own name: ``utils`` and ``yarp`` are others' there."""
    return bool(_names().match(canonicalize_name(module)))


@cache
def widespread_stems() -> frozenset[str]:
    """Return beginnings of names that packages of many authors share: ``torch``, ``flask``."""
    return frozenset(row["stem"] for row in rows("widespread_stems"))


@cache
def _names() -> re.Pattern[str]:
    return named_by(canonicalize_name(row["module"]) for row in rows("never_by_name"))
