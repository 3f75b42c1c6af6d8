"""Files and folders at the top of a repository that a compilation does not read, unless a build file names them."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import one_of


@cache
def unread() -> re.Pattern[str]:
    """Return one pattern that matches the full name of each of them."""
    return one_of(row["pattern"] for row in rows("unread"))
