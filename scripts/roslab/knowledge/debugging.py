"""Packages that pages name for those who work on the code: no program of the image needs them to run."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import one_of


@cache
def debugging() -> re.Pattern[str]:
    """Return one pattern that matches the full name of each of them in apt."""
    return one_of(row["pattern"] for row in rows("debugging"))
