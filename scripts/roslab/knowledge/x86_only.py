"""What only compilers for x86 know: options, headers, and the macros that tell of such a processor."""

from __future__ import annotations

import re
from functools import cache
from typing import Literal

from roslab.knowledge.table import rows
from roslab.values.pattern import pattern


@cache
def x86_only(what: Literal["option", "header", "macro"]) -> re.Pattern[str]:
    """Return a pattern for all options, headers or macros that only x86 has; it matches one as a whole word."""
    each = "|".join(row["pattern"] for row in rows("x86_only") if row["what"] == what)
    return pattern(rf"(?<![\w.=-])(?:{each})(?![\w.=-])")
