"""Variables by which ROS and the packages of robots are told how to run, whatever the machine."""

from __future__ import annotations

from fnmatch import fnmatchcase

from roslab.knowledge.table import rows


def of_robots(name: str) -> bool:
    """Tell whether a variable of an author's own image belongs in every image of the repository."""
    return any(fnmatchcase(name, row["name"]) for row in rows("robot_variables"))
