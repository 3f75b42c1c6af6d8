"""The ROS packages that hold the plugins of Gazebo, by the names of their libraries."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from roslab.knowledge.table import rows


@cache
def gazebo_plugins() -> Mapping[str, str]:
    """Return the package of each library: ``libgazebo_ros_camera.so``."""
    return {row["library"]: row["ros"] for row in rows("gazebo_plugins")}
