"""Settings of a pyproject.toml that newer releases of its build backend refuse."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated


@dataclass(frozen=True, kw_only=True, slots=True)
class BackendSetting:
    """One of them."""

    keys: tuple[str, ...]
    """Below ``tool``."""
    unless: tuple[str, ...]
    """Below ``tool``: the setting with which the author says himself for which releases his are written."""
    limit: Requirement


@cache
def backend_settings() -> tuple[BackendSetting, ...]:
    """Return the table."""
    return tuple(
        BackendSetting(
            keys=tuple(row["setting"].split(".")),
            unless=tuple(row["unless"].split(".")),
            limit=stated(row["limit"]),
        )
        for row in rows("backend_settings")
    )
