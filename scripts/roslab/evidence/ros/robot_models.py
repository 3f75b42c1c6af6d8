"""Which model of a robot the tree means: the one that it sets, else the one that its launch files name.

``export TURTLEBOT3_MODEL=waffle``, and ``-model turtlebot3_waffle`` of what spawns it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.xml_comments import without_xml_comments
from roslab.evidence.ros.middlewares import setting_files
from roslab.knowledge.robot_models import RobotModels, robot_models
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 400
"""Most files that are opened of each sort, those nearest to the root first."""
_PAGES = (".md", ".rst")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield what is set, a page's value first, then the first place that names a model where all launch files agree.

    Where they name several, each file's first place for each of them, as a topic of its own.
    """
    yield from _set(repository)
    launching = (file for file in repository.suffixed(".launch", ".py", ".xml") if "launch" in file.path)
    files = [file for file in launching if file.size <= MAX_SIZE and not places.aside(file.path)]
    found: dict[str, dict[tuple[str, str], Mention]] = {}
    for file in nearest(files)[:MAX_FILES]:
        text = repository.read(file)
        for robot in robot_models():
            if robot.family not in text:
                continue
            text = text if file.path.endswith(".py") else without_xml_comments(text)
            for match in _named(robot).finditer(text):
                said = _mention(robot, match, file, text)
                found.setdefault(robot.variable, {}).setdefault((match[1], file.path), said)
    for places_of in found.values():
        first, *others = places_of.values()
        if all(each.value == first.value for each in others):
            yield first
        else:
            yield from (replace(each, topic="robot_models") for each in (first, *others))


def _set(repository: Repository) -> Iterator[Mention]:
    """Yield the first place that sets each variable to a model: a page, else what starts the robot."""
    files = nearest(setting_files(repository))
    pages = [file for file in files if file.path.endswith(_PAGES)]
    others = [file for file in files if not file.path.endswith(_PAGES)]
    found: set[str] = set()
    for file in (*pages[:MAX_FILES], *others[:MAX_FILES]):
        text = repository.read(file)
        for robot in robot_models():
            for match in _given(robot).finditer(text) if robot.variable in text else ():
                before = text[text.rfind("\n", 0, match.start()) + 1 : match.start()]
                if robot.variable not in found and not ("#" in before or "<!--" in before):
                    found.add(robot.variable)
                    yield _mention(robot, match, file, text)


def _mention(robot: RobotModels, match: re.Match[str], file: File, text: str) -> Mention:
    return Mention(
        topic="robot_model",
        value=f"{robot.variable}={match[1]}",
        source="readme" if file.path.endswith(_PAGES) else "launch",
        file=file.path,
        line=text.count("\n", 0, match.start()) + 1,
        text=match[0],
    )


def _given(robot: RobotModels) -> re.Pattern[str]:
    """Return the pattern of the variable with a model behind it: set, or a default where nothing sets it."""
    names = "|".join(sorted(map(re.escape, robot.models), key=len, reverse=True))
    return pattern(
        rf"\b{robot.variable}[\"'\]]{{0,3}}(?: ?[=,]\s{{0,80}}|:[-=]?[ \t]?|[ \t]{{1,4}})"
        rf"(?:(?:default_)?value[ \t]?=[ \t]?)?[\"']?({names})(?![\w-])"
    )


def _named(robot: RobotModels) -> re.Pattern[str]:
    """Return the pattern of a name of the robot's model, of the longest name that fits."""
    names = "|".join(sorted(map(re.escape, robot.models), key=len, reverse=True))
    return pattern(rf"\b{re.escape(robot.family)}({names})(?![a-z0-9]|_(?!\d))")
