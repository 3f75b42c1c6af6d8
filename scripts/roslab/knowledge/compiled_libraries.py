"""Libraries that a project compiles with its own code, and what their builds look for on the system."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def compiled_libraries() -> dict[str, tuple[str, ...]]:
    """Return the apt packages for each by its name in lower case, as its repository or its folder is called."""
    return {row["library"]: tuple(row["apt"].split()) for row in rows("compiled_libraries")}


@cache
def required_by() -> dict[str, tuple[str, ...]]:
    """Return the names that the CMake of each gives ``find_package`` and stops without."""
    return {row["library"]: tuple(row["requires"].split()) for row in rows("compiled_libraries") if row["requires"]}
