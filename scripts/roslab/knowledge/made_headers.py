"""Headers that a licensed program makes with its code, or brings for it: no package of a system has them."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import pattern


def made_by(header: str) -> str | None:
    """Return the program that makes or brings a header, ``None`` for all others."""
    return next((tool for names, tool in _rows() if names.fullmatch(header)), None)


@cache
def _rows() -> tuple[tuple[re.Pattern[str], str], ...]:
    return tuple((pattern(row["pattern"]), row["tool"]) for row in rows("made_headers"))
