"""Libraries that open windows."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows


@cache
def _patterns() -> dict[str, tuple[re.Pattern[str], ...]]:
    kinds = dict.fromkeys(row["where"] for row in rows("windows"))
    return {
        kind: tuple(re.compile(row["pattern"]) for row in rows("windows") if row["where"] == kind) for kind in kinds
    }


def opens(where: str, name: str) -> bool:
    """Tell whether a library opens windows, by its name for ``find_package``, its header or its Python module."""
    return any(pattern.search(name) for pattern in _patterns().get(where, ()))
