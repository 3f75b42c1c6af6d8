"""The model of a robot that the default command needs to be told by a variable, and that no page tells."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import NamedTuple

from roslab.decide.candidate import launched_by
from roslab.decide.decision import Warning_
from roslab.decide.launch_calls import started_launch
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.robot_models import RobotModels, robot_models


class UntoldModel(NamedTuple):
    """A variable that no page sets."""

    set: tuple[str, str, str, Mention | None]
    """Its name and value, why, and where that is said."""
    warning: Warning_ | None = None
    """Where nothing says the model."""


def untold_models(evidence: Evidence, argv: tuple[str, ...] | str, there: Collection[str]) -> tuple[UntoldModel, ...]:
    """Return such variables of the default command that are not ``there``: roslaunch stops at once without them.

    The value is the model that the launch files of the tree name, else the one that the robot's manual begins with.
    """
    needed = [robot for robot in _needed(evidence, argv) if robot.variable not in there]
    return tuple(_model(robot, evidence) for robot in needed)


def _needed(evidence: Evidence, argv: tuple[str, ...] | str) -> Iterator[RobotModels]:
    words = launched_by(argv) if isinstance(argv, tuple) and argv else ()
    if not words:
        return
    launch = started_launch(evidence, argv)
    used = {words[0]}
    if launch:
        used |= {asked.name for asked in (*launch.dependencies, *launch.reached) if asked.namespace == "ros"}
    read = {name for name, _ in launch.variables} if launch else set[str]()
    yield from (robot for robot in robot_models() if robot.variable in read or used & robot.packages)


def _model(robot: RobotModels, evidence: Evidence) -> UntoldModel:
    for said in evidence.mentions:
        name, _, value = said.value.partition("=")
        if said.topic == "robot_model" and name == robot.variable:
            return UntoldModel(set=(name, value, "the launch files name that model", said))
    first = robot.models[0]
    why = f"nothing says which of {', '.join(robot.models)} the default command is for, and it stops without"
    told = f"{why} {robot.variable}: {first} is taken; set another under `env` in roslab.yaml"
    return UntoldModel(set=(robot.variable, first, f"{why} one", None), warning=warn(told))
