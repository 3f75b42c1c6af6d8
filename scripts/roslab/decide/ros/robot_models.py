"""The model of a robot that the default command needs to be told by a variable, where its section does not set it."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import NamedTuple

from roslab.decide.candidate import launched_by
from roslab.decide.decision import Warning_
from roslab.decide.launch_calls import started_launch
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.launch_file import LaunchFile
from roslab.knowledge.robot_models import RobotModels, robot_models
from roslab.values.origin import Place


class UntoldModel(NamedTuple):
    """A variable that no page sets for the command."""

    set: tuple[str, str, str, Mention | None]
    """Its name and value, why, and where that is said."""
    warning: Warning_ | None = None
    """Where nothing says the model."""


def untold_models(evidence: Evidence, argv: tuple[str, ...] | str, there: Collection[str]) -> tuple[UntoldModel, ...]:
    """Return such variables of the default command that are not ``there``: roslaunch stops at once without them.

    The value is the one that the tree sets anywhere, else the model that its launch files name, of several the one that
    the command's names or the first, else the one that the robot's manual begins with.
    """
    launch = started_launch(evidence, argv) if argv else None
    needed = [robot for robot in _needed(launch, argv) if robot.variable not in there]
    return tuple(_model(robot, evidence, launch) for robot in needed)


def _needed(launch: LaunchFile | None, argv: tuple[str, ...] | str) -> Iterator[RobotModels]:
    words = launched_by(argv) if isinstance(argv, tuple) and argv else ()
    if not words:
        return
    used = {words[0]}
    if launch:
        used |= {asked.name for asked in (*launch.dependencies, *launch.reached) if asked.namespace == "ros"}
    read = {name for name, _ in launch.variables} if launch else set[str]()
    yield from (robot for robot in robot_models() if robot.variable in read or used & robot.packages)


def _model(robot: RobotModels, evidence: Evidence, launch: LaunchFile | None) -> UntoldModel:
    for said in evidence.mentions:
        name, _, value = said.value.partition("=")
        if said.topic == "robot_model" and name == robot.variable:
            why = "it is set there" if name in said.text else "the launch files name that model"
            return UntoldModel(set=(name, value, why, said))
    named = [m for m in evidence.mentions if m.topic == "robot_models" and m.value.startswith(f"{robot.variable}=")]
    of_file = [m for m in named if launch and m.file == launch.file]
    if len({m.value for m in of_file}) == 1:
        value = of_file[0].value.partition("=")[2]
        return UntoldModel(set=(robot.variable, value, "its launch file names that model", of_file[0]))
    models = tuple(dict.fromkeys(m.value.partition("=")[2] for m in of_file or named))
    first = (models or robot.models)[0]
    why = f"nothing says which of {', '.join(robot.models)} the default command is for, and it stops without"
    if models:
        why = f"the launch files name the models {', '.join(models)}, and the default command stops without"
    told = f"{why} {robot.variable}: {first} is taken; set another under `env` in roslab.yaml"
    lines = [line for name, line in launch.variables if name == robot.variable] if launch else []
    place = Place(file=launch.file, line=lines[0] if lines else launch.line) if launch else None
    return UntoldModel(set=(robot.variable, first, f"{why} one", None), warning=warn(told, place))
