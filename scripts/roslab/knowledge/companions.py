"""Packages that functions of others need, and that pip does not install with those."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.hints import Hints, Search, hints
from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern


@dataclass(frozen=True, kw_only=True, slots=True)
class Companion:
    """What the use of one function of a package needs."""

    package: str
    """A package, or a module of which the distribution's package has no such part yet."""
    hints: Hints
    pattern: re.Pattern[str]
    needs: str
    """As a line of requirements; with the first version that has it only for such a module."""


@cache
def companions() -> Search[Companion]:
    """Return the table, to be searched for by the words of modules."""
    found = (
        record(Companion, row, hints=hints(row["hints"]), pattern=pattern(row["pattern"])) for row in rows("companions")
    )
    return Search(found, words=True)
