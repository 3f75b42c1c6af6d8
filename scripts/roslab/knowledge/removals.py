"""Names that a Python package no longer has: code that uses one runs only with older versions."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.hints import Hints, hints
from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated


@dataclass(frozen=True, kw_only=True, slots=True)
class Removal:
    """One removed name of one package."""

    rank: int
    """Its place in the table: of a package, that of the lowest bound is the first."""
    package: str
    having: str
    """The versions that still have it, ``matplotlib<3.5``."""
    with_it: str
    """A bound that these versions need on another package, ``""`` for none: code compiled against NumPy 1 does not load
    with NumPy 2 (https://numpy.org/doc/stable/numpy_2_0_migration_guide.html)."""
    hints: Hints
    pattern: re.Pattern[str]
    what: str
    source: str

    @property
    def bound(self) -> Requirement:
        """What ``having`` asks for."""
        return stated(self.having)

    @property
    def beside(self) -> Requirement | None:
        """What ``with_it`` asks for."""
        return stated(self.with_it) if self.with_it else None


@cache
def removals() -> tuple[Removal, ...]:
    """Return the table."""
    return tuple(
        record(
            Removal,
            row,
            rank=rank,
            having=row["bound"],
            with_it=row["beside"],
            hints=hints(row["hints"]),
            pattern=pattern(row["pattern"]),
        )
        for rank, row in enumerate(rows("removals"))
    )


@cache
def newer_api() -> dict[str, re.Pattern[str]]:
    """Return by package the names that only its newer versions have: code that uses them is not for the older ones."""
    return {row["package"]: pattern(row["pattern"]) for row in rows("newer_api")}
