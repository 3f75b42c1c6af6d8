"""Files at a repository's root by which a build tool builds it that no step of the image calls."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def other_builders() -> dict[str, str]:
    """Return the tool of each file."""
    return {row["file"]: row["builder"] for row in rows("other_builders")}


@cache
def of_cpp() -> frozenset[str]:
    """Return the tools that are used for C++ before all."""
    return frozenset(row["builder"] for row in rows("other_builders") if row["compiles_cpp"] == "yes")
