"""Steps of an author's Dockerfile that stop on bases of certain releases, whatever else the image has."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import pattern


def stopped(step: str, releases: str) -> str:
    """Return why a step stops, ``""`` where it may not; ``releases``: the base's name and the steps so far."""
    for release, asked, why in _rows():
        if asked.search(step) and release.search(releases):
            return why
    return ""


@cache
def _rows() -> tuple[tuple[re.Pattern[str], re.Pattern[str], str], ...]:
    return tuple((pattern(row["release"]), pattern(row["step"]), row["why"]) for row in rows("stopped_steps"))
