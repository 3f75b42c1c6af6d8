"""What conda must not take beside a package, which does not say so itself."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class CondaLimit:
    """A limit beside a package of ``before`` a release and from a channel, ``""`` for any."""

    name: str
    before: str
    channel: str
    limit: str
    why: str


@cache
def conda_limits() -> tuple[CondaLimit, ...]:
    """Return the limits of the table."""
    return tuple(record(CondaLimit, row, name=row["conda"]) for row in rows("conda_limits"))
