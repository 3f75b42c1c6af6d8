"""Extras of the packages of learning environments, without which some environments cannot be made."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.native_parts import Series, series
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class EnvironmentExtras(Series):
    """What the games of Atari need beside a package."""

    needs: tuple[str, ...]
    """As lines of requirements without versions."""


@cache
def environment_extras() -> tuple[EnvironmentExtras, ...]:
    """Return all rows of the table."""
    return tuple(
        EnvironmentExtras(**series(row), needs=tuple(row["needs"].split())) for row in rows("environment_extras")
    )
