"""What conda must not take beside a package, which does not say so itself."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from roslab.knowledge.table import rows


class CondaLimit(NamedTuple):
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
