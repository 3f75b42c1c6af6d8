"""The variables with which Python packages draw without a display, and those with which they open a window."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def offscreen() -> dict[str, tuple[str, str]]:
    """Return each package of pip, by its normalised name, with the variable and its value."""
    return {row["pip"]: (row["variable"], row["value"]) for row in rows("offscreen")}


@cache
def onscreen() -> dict[str, tuple[frozenset[str], str, str]]:
    """Return the same of packages that stop where they open a window, before it the libraries whose window it is.

    Without that window the variable stops the same packages where they draw.
    """
    return {row["pip"]: (frozenset(row["windows"].split()), row["variable"], row["value"]) for row in rows("onscreen")}
