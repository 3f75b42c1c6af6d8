"""Packages that have the name of a module which another one brings: tools that write lists mistake them for it."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Mistaken:
    """What brings the module, beside which nobody means the package, by its normalised name."""

    beside: str
    module: str
    source: str


@cache
def mistaken_packages() -> dict[str, Mistaken]:
    """Return the table by normalised name."""
    return {row["pip"]: record(Mistaken, row) for row in rows("mistaken_packages")}
