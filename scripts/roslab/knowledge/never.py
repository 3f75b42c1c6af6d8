"""Packages that pages name but no image can use: drivers, kernels, the Docker engine itself."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import one_of


@cache
def never() -> re.Pattern[str]:
    """Return one pattern that matches the full name of each of them."""
    return one_of(row["pattern"] for row in rows("never"))
