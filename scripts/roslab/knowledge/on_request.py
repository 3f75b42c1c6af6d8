"""System packages that a key of roslab.yaml stands for, by Ubuntu."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def _table() -> dict[tuple[str, str], tuple[str, ...]]:
    return {
        (row["key"], ubuntu): tuple(row["packages"].split())
        for row in rows("on_request")
        for ubuntu in row["ubuntu"].split()
    }


def packages(key: str, ubuntu: str | None) -> tuple[str, ...]:
    """Return the packages of a key, none if this Ubuntu does not have them or the base is not Ubuntu."""
    return _table().get((key, ubuntu or ""), ())
