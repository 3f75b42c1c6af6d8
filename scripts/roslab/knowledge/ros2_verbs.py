"""The ROS packages that bring commands of ``ros2`` which not every base has: those of ros2cli itself are in all."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from roslab.knowledge.table import rows


@cache
def ros2_verbs() -> Mapping[str, str]:
    """Return the package of each command: ``control``."""
    return {row["verb"]: row["ros"] for row in rows("ros2_verbs")}
