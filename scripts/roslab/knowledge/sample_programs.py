"""The one call of the programs that tools write into a new project, to be replaced by its own."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import pattern


@cache
def sample_call() -> re.Pattern[str]:
    """Return what finds the call of any of them."""
    return pattern("|".join(f"(?:{row['call']})" for row in rows("sample_programs")))
