"""The packages of Gazebo's plugins that the robots and sensors of other packages load, which these do not ask for."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from roslab.knowledge.table import rows


@cache
def described_plugins() -> Mapping[str, tuple[str, ...]]:
    """Return what the descriptions of each package load: a robot of ``turtlebot3_description`` drives by a plugin."""
    return {row["package"]: tuple(row["loads"].split()) for row in rows("described_plugins")}
