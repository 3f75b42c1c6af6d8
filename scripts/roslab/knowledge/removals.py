"""Names that a Python package no longer has: code that uses one runs only on the versions before."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache

from roslab.knowledge.table import rows


@dataclass(frozen=True, kw_only=True, slots=True)
class Removal:
    """One removed name of one package."""

    package: str
    bound: str
    """The requirement that still has it, ``matplotlib<3.5``."""
    beside: str
    """A bound that those versions need in turn: they were compiled against NumPy 1, and NumPy 2 loads none of them
    (https://numpy.org/doc/stable/numpy_2_0_migration_guide.html); ``""`` for none."""
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
            bound=row["bound"],
            beside=row["beside"],
            hint=row["hint"],
            pattern=re.compile(row["pattern"]),
            what=row["what"],
            source=row["source"],
        )
        for row in rows("removals")
    )
