"""Files of the tree that a page names from where people clone it to: from the workspace, or the folder above."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence

from roslab.evidence.prose.started_in import ends
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern
from roslab.values.words import written

_SHORTEST = 4
"""Fewest letters by which the name of a fork is known."""
_ELSEWHERE = pattern(r"~/|/(?:home|root|path/to)/|\$\{?\w+\}?/|…/")
"""What a path begins with that leads to the reader's own folders."""
_SOURCES = "src/"
_FOUND = "…/"
"""What stands for a value that only a running shell knows."""
_SHARE = pattern(r"^share/[\w-]+/")
"""``$(ros2 pkg prefix demo)/share/demo/cfg/a.yaml``."""


def in_workspace(path: str, words: Sequence[str], repository: Repository) -> str | None:
    """Return the path from the root of what a command of ROS names from its workspace: ``src/demo/cfg/a.yaml``.

    So it is with what it names from a folder that a shell finds: ``$(rospack find demo)/cfg/a.yaml``.
    """
    below = path.removeprefix(_SOURCES)
    if not _starts(words) or repository.has(path) or not repository.named("package.xml"):
        return None
    if path.startswith(_FOUND):
        return _of_package(_SHARE.sub("", path.removeprefix(_FOUND)), repository)
    if below == path:
        return None
    return from_above(below, repository) or (below if repository.has(below) else None)


def given_from_workspace(words: list[str], inside: str, repository: Repository) -> tuple[list[str], list[str]]:
    """Return the words with the files that they give a node or a launch file of ROS 2 behind ``:=``, and those words.

    Nodes of roslaunch start in a folder of their own. ``inside``: the folder that the page went to; from one of the
    tree no such path leads anywhere.
    """
    starts = _starts(words)
    if not starts or starts == "roslaunch" or any(each in repository.folders for each in ends(inside) if each):
        return words, []
    given = {}
    for word in words:
        name, sign, value = written(word).partition(":=")
        path = posixpath.normpath(value) if "/" in value else ""
        if found := path and (in_checkout(path, repository) or in_workspace(path, words, repository)):
            given[word] = f"{name}{sign}{found}"
    return [given.get(word, word) for word in words], [*given.values()]


def _of_package(path: str, repository: Repository) -> str | None:
    """Return the one file of the tree whose path ends so, in a folder at least."""
    named = repository.named(posixpath.basename(path)) if "/" in path else ()
    found = [file.path for file in named if f"/{file.path}".endswith(f"/{path}")]
    return found[0] if len(found) == 1 else None


def _starts(words: Sequence[str]) -> str:
    """Return the words with which a command starts something of ROS, ``""`` for another."""
    start = " ".join(words[:2]) if words[:1] == ["ros2"] else "".join(words[:1])
    return start if start in {"rosrun", "roslaunch", "ros2 run", "ros2 launch"} else ""


def in_checkout(path: str, repository: Repository) -> str | None:
    """Return the path from the root of what a page names where people clone to: ``~/catkin_ws/src/demo/cfg/a.yaml``.

    Not of an argument of a launch file, whose nodes start in a folder of their own. The page of a fork may have the
    name of what it was forked from: ``demo`` in ``demo-gpu``. In ``src`` of a workspace a package of the tree may lie
    by its own name: ``~/catkin_ws/src/arm/run.sh``.
    """
    parts = path.split("/")
    if not _ELSEWHERE.match(path) or ":=" in path:
        return None
    names = [place for place, part in enumerate(parts) if _is_name(part, repository.name)]
    rests = ("/".join(parts[place + 1 :]) for place in reversed(names))
    there = next((rest for rest in rests if repository.has(rest) or rest in repository.folders), None)
    return there or _of_package(path.partition("/src/")[2], repository)


def from_above(path: str, repository: Repository) -> str | None:
    """Return the path from the root of a file that a page names from the folder which the clone lies in: ``demo/a.py``.

    The root may hold a folder of that name, too: a file of it comes first.
    """
    first, _, rest = path.partition("/")
    if not rest or ":=" in path or repository.has(path) or path in repository.folders:
        return None
    return rest if _is_name(first, repository.name) and repository.has(rest) else None


def _is_name(part: str, name: str) -> bool:
    own, other = name.lower(), part.lower()
    return own == other or (len(other) >= _SHORTEST and own.startswith((f"{other}-", f"{other}_")))
