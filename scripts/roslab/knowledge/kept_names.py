"""Names that a library dropped and that the header of another one still brings."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import pattern


@cache
def kept_names() -> dict[str, re.Pattern[str]]:
    """Return the names that each header brings."""
    return {row["header"]: pattern(row["pattern"]) for row in rows("kept_names")}
