"""The ROS packages that hold the hardware of ros2_control, where its plugins are called otherwise."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


def package_of_hardware(plugins: str) -> str:
    """Return the package of plugins of one name: that name itself, but for a few: ``mock_components``."""
    return _packages().get(plugins, plugins)


@cache
def _packages() -> dict[str, str]:
    return {row["plugins"]: row["package"] for row in rows("hardware_plugins")}
