"""Packages that pages name but no image can use: drivers, kernels, the engine itself."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows


@cache
def never() -> re.Pattern[str]:
    """Return one pattern that matches the whole of each such name."""
    return re.compile("(?:" + "|".join(row["pattern"] for row in rows("never")) + r")\Z")
