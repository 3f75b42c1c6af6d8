"""Variables by which ROS and the packages of robots are told how to run, whatever the machine."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.table import rows
from roslab.values.pattern import named_by


def of_robots(name: str) -> bool:
    """Tell whether a variable of an author's own image belongs in every image of the repository."""
    return bool(_names().match(name))


@cache
def _names() -> re.Pattern[str]:
    return named_by(row["name"] for row in rows("robot_variables"))
