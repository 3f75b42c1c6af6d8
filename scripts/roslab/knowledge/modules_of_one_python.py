"""Modules of ROS 1 that are compiled, or need such: its packages have them for the distribution's own Python alone."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def modules_of_one_python() -> dict[str, tuple[str, str]]:
    """Return the ROS package that has the compiled part of each module, and the repository that this comes from."""
    return {row["module"]: (row["ros"], row["repository"]) for row in rows("modules_of_one_python")}
