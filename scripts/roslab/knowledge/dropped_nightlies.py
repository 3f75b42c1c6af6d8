"""Packages of nightly builds of which pip's index keeps the last months alone."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Nightly:
    """The package with the stable releases, and the day of the oldest build that the index had when it was looked."""

    stable: str
    since: str


@cache
def dropped_nightlies() -> dict[str, Nightly]:
    """Return the table by normalised name; what is older than its day does not come back."""
    return {row["pip"]: record(Nightly, row) for row in rows("dropped_nightlies")}
