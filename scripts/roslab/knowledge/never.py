"""Packages that pages name but no image can use: drivers, kernels, the Docker engine itself."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows


@cache
def never() -> re.Pattern[str]:
    """Return one pattern that matches the full name of each of them."""
    return re.compile("(?:" + "|".join(row["pattern"] for row in rows("never")) + r")\Z")
