"""What the sources of a compiled extension include or call, and the releases of a package that still have it."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern


@dataclass(frozen=True, kw_only=True, slots=True)
class Dropped:
    """Something in C++ that a package has dropped."""

    package: str
    pattern: re.Pattern[str]
    below: str
    """The first release without it."""
    define: str
    """A macro that puts the new name in its place, ``""`` where there is none: ``NAME=TEXT`` or ``NAME(...)=TEXT``."""
    what: str
    hint: str
    """Every match holds it."""


@cache
def dropped() -> tuple[Dropped, ...]:
    """Return the table."""
    return tuple(
        record(Dropped, row, pattern=pattern(row["pattern"], re.MULTILINE), hint=row["hints"])
        for row in rows("extension_code")
    )
