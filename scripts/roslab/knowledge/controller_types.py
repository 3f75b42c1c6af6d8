"""The packages of controllers whose types do not name them."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import pattern


@cache
def controller_package(type_: str, ros: int) -> str:
    """Return the package of a type like ``position_controllers/JointTrajectoryController``, ``""`` if it names it."""
    of_ros = (row for row in rows("controller_types") if row["ros"] == str(ros))
    return next((row["package"] for row in of_ros if pattern(row["pattern"]).fullmatch(type_)), "")
