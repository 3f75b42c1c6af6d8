"""Which Pythons have wheels for releases that stand together in one list."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.knowledge.frameworks import Framework, framework
from roslab.values.version import Version


def together(pins: Iterable[tuple[str, str]]) -> str | None:
    """Return the newest Python that has wheels for all pins (package, release) that the tables know.

    ``None`` where there is none; ``""`` where the tables know none of them.
    """
    known = rows_of(pins)
    if not known:
        return ""
    newest = min((row.python_max for row in known), key=Version)
    return newest if all(row.runs_with(newest) for row in known) else None


def rows_of(pins: Iterable[tuple[str, str]]) -> list[Framework]:
    """Return the rows of the tables for pins; what is in no table, may have wheels for any Python."""
    return [row for name, release in pins if (row := framework(name, release))]
