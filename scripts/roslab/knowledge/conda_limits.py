"""What conda must not take beside a package, which does not say so itself."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, slots=True)
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
    return tuple(
        CondaLimit(row["conda"], row["before"], row["channel"], row["limit"], row["why"])
        for row in rows("conda_limits")
    )
