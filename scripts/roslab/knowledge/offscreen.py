"""The variables with which Python packages draw without a display, and those with which they open a window."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def offscreen() -> dict[str, tuple[str, str]]:
    """Return each package of pip, by its normalised name, with the variable and its value."""
    return _variables("offscreen")


@cache
def onscreen() -> dict[str, tuple[str, str]]:
    """Return the same of the packages that stop where they open a window."""
    return _variables("onscreen")


def _variables(table: str) -> dict[str, tuple[str, str]]:
    return {row["pip"]: (row["variable"], row["value"]) for row in rows(table)}
