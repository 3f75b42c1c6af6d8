"""Packages of conda that Windows or macOS alone has, in the releases that its lists name."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern


@dataclass(frozen=True, kw_only=True, slots=True)
class OfSystem:
    """Such a package."""

    names: re.Pattern[str]
    system: str
    sign: bool
    """A list that names it was written there."""


@cache
def of_systems() -> tuple[OfSystem, ...]:
    """Return the table; names are whole, as conda writes them."""
    return tuple(
        OfSystem(names=pattern(row["package"]), system=row["system"], sign=bool(row["sign"]))
        for row in rows("conda_systems")
    )
