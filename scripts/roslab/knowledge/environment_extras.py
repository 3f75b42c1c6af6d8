"""Extras of the packages of learning environments, without which some environments cannot be made."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.native_parts import Series
from roslab.knowledge.record import record
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
    return tuple(record(EnvironmentExtras, row) for row in rows("environment_extras"))
