"""Variables that say which model of a robot is there, without which the launch files of its packages do not start."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class RobotModels:
    """The models of one robot."""

    variable: str
    family: str
    """What stands before the name of a model: ``turtlebot3_``."""
    packages: frozenset[str]
    """Those whose launch files or nodes read it."""
    models: tuple[str, ...]
    """The one first that the robot's own manual begins with."""


@cache
def robot_models() -> tuple[RobotModels, ...]:
    """Return the models of each robot."""
    return tuple(
        RobotModels(
            variable=row["variable"],
            family=row["family"],
            packages=frozenset(row["packages"].split()),
            models=tuple(row["models"].split()),
        )
        for row in rows("robot_models")
    )
