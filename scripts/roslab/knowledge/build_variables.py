"""The variables that the build of packages reads which many workspaces clone."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from roslab.knowledge.table import rows


@cache
def build_variables() -> Mapping[str, str]:
    """Return each with the packages whose build reads it, in words."""
    return {row["name"]: row["readers"] for row in rows("build_variables")}
