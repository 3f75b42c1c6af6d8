"""The last releases of packages for a Python: whoever lists several of them had that Python."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def last_for_python() -> dict[tuple[str, str], str]:
    """Return the Python for which a release was the last of its package, by normalised name and release."""
    return {(row["pip"], row["release"]): row["python"] for row in rows("last_for_python")}
