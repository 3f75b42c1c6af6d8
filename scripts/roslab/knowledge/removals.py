"""Names that a Python package no longer has: code that uses one runs only with older versions."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated


@dataclass(frozen=True, kw_only=True, slots=True)
class Removal:
    """One removed name of one package."""

    package: str
    bound: Requirement
    """The versions that still have it, ``matplotlib<3.5``."""
    beside: Requirement | None
    """A bound that these versions need on another package: code compiled against NumPy 1 does not load with NumPy 2
    (https://numpy.org/doc/stable/numpy_2_0_migration_guide.html)."""
    hint: str
    """A literal that every match contains: files without it are not searched."""
    pattern: re.Pattern[str]
    what: str
    source: str


@cache
def removals() -> tuple[Removal, ...]:
    """Return the table; the lowest bound of a package comes first."""
    return tuple(
        Removal(
            package=row["package"],
            bound=stated(row["bound"]),
            beside=stated(row["beside"]) if row["beside"] else None,
            hint=row["hint"],
            pattern=re.compile(row["pattern"]),
            what=row["what"],
            source=row["source"],
        )
        for row in rows("removals")
    )
