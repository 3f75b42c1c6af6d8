"""Headers that ROS generates from messages, services and actions, and the packages that these belong to.

ROS 1 names them as the message, ``nav_msgs/GridCells.h``, ROS 2 by folders, ``nav_msgs/msg/grid_cells.hpp``.
https://wiki.ros.org/msg https://docs.ros.org/en/rolling/Concepts/Basic/About-Interfaces.html
"""

from __future__ import annotations

from functools import cache

from roslab.values.pattern import pattern

_GENERATED = pattern(
    r"([a-z][a-z0-9]*(?:_[a-z0-9]+)+)/[A-Z][A-Za-z0-9]*\.h|"
    r"([a-z][a-z0-9]*(?:_[a-z0-9]+)*)/(?:msg|srv|action)/[a-z][a-z0-9_]*\.hpp"
)
"""In ROS 1 only a name of two words: libraries have headers of such names, ``ace/Task.h``."""


@cache
def package_of(header: str) -> str:
    """Return the package whose message a header is generated from, ``""`` for other headers."""
    match = _GENERATED.fullmatch(header)
    return (match[1] or match[2]) if match else ""
