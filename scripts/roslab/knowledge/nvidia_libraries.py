"""Libraries that CMake looks for and NVIDIA's own package sources and images alone have."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def nvidia_libraries() -> frozenset[str]:
    """Return their names, as ``find_package`` has them."""
    return frozenset(row["name"] for row in rows("nvidia_libraries"))
