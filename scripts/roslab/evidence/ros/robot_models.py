"""Which model of a robot the launch files of the tree name: ``-model turtlebot3_waffle``."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.xml_comments import without_xml_comments
from roslab.knowledge.robot_models import RobotModels, robot_models
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 400
"""Most launch files that are opened, those nearest to the root first."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first place that names a model, for each robot of which all launch files name the same one."""
    launching = (file for file in repository.suffixed(".launch", ".py", ".xml") if "launch" in file.path)
    files = [file for file in launching if file.size <= MAX_SIZE and not places.aside(file.path)]
    found: dict[str, dict[str, Mention]] = {}
    for file in nearest(files)[:MAX_FILES]:
        text = repository.read(file)
        for robot in robot_models():
            if robot.family not in text:
                continue
            text = text if file.path.endswith(".py") else without_xml_comments(text)
            for match in _named(robot).finditer(text):
                line = text.count("\n", 0, match.start()) + 1
                said = Mention(
                    topic="robot_model",
                    value=f"{robot.variable}={match[1]}",
                    source="launch",
                    file=file.path,
                    line=line,
                    text=match[0],
                )
                found.setdefault(robot.variable, {}).setdefault(match[1], said)
    yield from (next(iter(models.values())) for models in found.values() if len(models) == 1)


def _named(robot: RobotModels) -> re.Pattern[str]:
    """Return the pattern of a name of the robot's model, of the longest name that fits."""
    names = "|".join(sorted(map(re.escape, robot.models), key=len, reverse=True))
    return pattern(rf"\b{re.escape(robot.family)}({names})(?![a-z0-9]|_(?!\d))")
