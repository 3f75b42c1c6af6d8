"""Projects of COIN-OR that ``coinbrew`` fetches and builds, and the packages of apt that bring them."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def coinbrew() -> dict[str, str]:
    """Return the package of apt that brings a project, by the project's name in lower case."""
    return {row["project"].lower(): row["apt"] for row in rows("coinbrew")}
