"""The variables that have Python packages draw without a display: by default they open a window, or stop."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def offscreen() -> dict[str, tuple[str, str]]:
    """Return each package of pip, by its normalised name, with the variable and its value."""
    return {row["pip"]: (row["variable"], row["value"]) for row in rows("offscreen")}
