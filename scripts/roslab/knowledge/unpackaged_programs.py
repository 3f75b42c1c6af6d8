"""Programs that scripts call and that no package of Ubuntu brings."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def unpackaged_programs() -> dict[str, str]:
    """Return by the program's name the address of its releases."""
    return {row["program"]: row["from"] for row in rows("unpackaged_programs")}
