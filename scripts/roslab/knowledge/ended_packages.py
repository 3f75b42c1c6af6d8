"""Packages that are released no more: the newest Python that their last release has wheels for."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def ended_packages() -> dict[str, str]:
    """Return that Python by the normalised name of the package."""
    return {row["pip"]: row["python_max"] for row in rows("ended_packages")}
