"""Headers of the compiler and what they bring along, and names that code uses without the header that has them."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern


@dataclass(frozen=True, kw_only=True, slots=True)
class MissedHeader:
    """A header of which other compilers, or older releases of GCC, bring the names along with others."""

    header: str
    names: re.Pattern[str]
    has: tuple[str, ...]
    """Of what stands in each of the names, one of these does: the others need not be looked for."""
    since: str | None
    """The first GCC that does not bring it along with the usual headers; ``None`` where no GCC ever did."""


@cache
def missed_headers() -> tuple[MissedHeader, ...]:
    """Return all rows."""
    return tuple(
        MissedHeader(
            header=row["header"],
            names=pattern(row["pattern"], re.MULTILINE),
            has=tuple(row["has"].split("|")),
            since=row["since"] or None,
        )
        for row in rows("missed_headers")
    )


@cache
def standard_headers() -> dict[str, frozenset[str]]:
    """Return each header of the compiler and of the C library with those of :func:`missed_headers` that it brings."""
    return {row["header"]: frozenset(row["brings"].split()) for row in rows("standard_headers")}
