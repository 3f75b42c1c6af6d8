"""CMake's modules that find what writes documentation: no program needs it."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def documenting() -> dict[str, str]:
    """Return the package of apt that each brings, by the name that ``find_package`` takes; ``""`` for none alone."""
    return {row["module"]: row["apt"] for row in rows("documentation")}
