"""Names that a Python package no longer has: code that uses one runs only on the versions before."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.requirement import Requirement, stated


@dataclass(frozen=True, kw_only=True, slots=True)
class Removal:
    """One removed name of one package."""

    package: str
    bound: Requirement
    """What still has it, ``matplotlib<3.5``."""
    beside: Requirement | None
    """A bound on another package that these versions need: what was compiled against NumPy 1 does not load with NumPy 2
    (https://numpy.org/doc/stable/numpy_2_0_migration_guide.html)."""
    hint: str
    """A literal that stands wherever the pattern matches: a file without it need not be searched."""
    pattern: re.Pattern[str]
    what: str
    source: str


@cache
def removals() -> tuple[Removal, ...]:
    """Return the table; a package's lowest bound stands first."""
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
