"""Calls of libraries that start a program of the system: saving a film by matplotlib starts ffmpeg."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.hints import Hints, Search, hints
from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern


@dataclass(frozen=True, kw_only=True, slots=True)
class ProgramCall:
    """What a call needs."""

    hints: Hints
    pattern: re.Pattern[str]
    apt: str
    """The package of the program."""


@cache
def program_calls() -> Search[ProgramCall]:
    """Return the table, to be searched for by the words of modules."""
    found = (
        record(ProgramCall, row, hints=hints(row["hints"]), pattern=pattern(row["pattern"]))
        for row in rows("program_calls")
    )
    return Search(found, words=True)
