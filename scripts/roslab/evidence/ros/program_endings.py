"""Programs of packages that a page names without the ending that CMake installs them with: ``.py``.

``ros2 run`` and ``rosrun`` find a program by its whole name alone (ros2/ros2cli: ros2run/ros2run/api/__init__.py;
ros/ros: tools/rosbash/scripts/rosrun; 2026-11-28).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.ros.launch import names_by_folder
from roslab.evidence.ros.unmade_nodes import COMMENT, RENAMES
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

ENDING = ".py"
_RUN = pattern(r"(?:rosrun|ros2 run) ([a-z]\w{0,60}) ([A-Za-z]\w{0,80})(?= |$)")


def read(repository: Repository, mentions: Iterable[Mention]) -> Iterator[Mention]:
    """Yield each such program with its package: the CMakeLists.txt names it with its ending alone."""
    told: set[tuple[str, str]] = set()
    for mention in mentions:
        said = _RUN.match(mention.value) if mention.topic == "command" and mention.source == "readme" else None
        if said is None or said.groups() in told:
            continue
        package, program = said.groups()
        told.add((package, program))
        if _named(program, _build_of(package, repository)):
            yield replace(mention, topic="ending", value=f"{package} {program}", files=(), inside="")


def _build_of(package: str, repository: Repository) -> str:
    """Return the CMakeLists.txt of a package of the tree without its comments, ``""`` where it has none, or two do."""
    folders = repository.once(_folders).get(package, ())
    path = f"{folders[0]}/CMakeLists.txt".lstrip("/") if len(folders) == 1 else ""
    return COMMENT.sub("", repository.read(path)) if path and repository.has(path) else ""


def _folders(repository: Repository) -> dict[str, list[str]]:
    """Return the folders of the tree's packages by their names."""
    found: dict[str, list[str]] = {}
    for folder, name in repository.once(names_by_folder).items():
        found.setdefault(name, []).append(folder)
    return found


def _named(program: str, text: str) -> bool:
    file = re.search(rf"(?<![\w-]){program}{re.escape(ENDING)}(?![\w.-])", text)
    other = re.search(rf"(?<![\w-]){program}(?![\w-]|\.py)", text)
    return bool(file) and not other and not RENAMES.search(text)
