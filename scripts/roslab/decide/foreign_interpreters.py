"""Interpreters of the author's machine that launch files start by: links in their places lead to the image's Python."""

from __future__ import annotations

from roslab.config.model import Config
from roslab.decide.decision import Choice
from roslab.decide.reasons import because
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import python_of_ubuntu, ubuntus_with_python2
from roslab.values.origin import Place
from roslab.values.pattern import pattern

LINKED = 40
"""Weight of the reason; nothing competes with it."""
_LEADS = "a link there leads to the image's Python"
_FIRST_LINE = "launch files start scripts whose first line names it"
_BY_IT = "a launch file names it, to start programs by it"
_PYTHON = pattern(r"(?!/root/)(?:/(?!\.\.?/)[\w.+@-]+)+/(python[\d.]*)")
"""The path of a Python; the image's user cannot look into ``/root``."""


def decide_interpreters(evidence: Evidence, config: Config, ubuntu: str | None) -> Choice[tuple[tuple[str, str], ...]]:
    """Return the paths that launch files name, or first lines of what they start, each with the program that is meant.

    None below a folder of the author's that the tree itself stands for.
    """
    if config.compatible:
        return Choice(answer=())
    found: dict[str, tuple[str, str, Place]] = {}
    for launch in evidence.launch:
        for file, named in launch.foreign:
            match = _PYTHON.fullmatch(named)
            if match and (python := _meant(match[1], ubuntu, alone=file in launch.without_ros)):
                found.setdefault(named, (python, _FIRST_LINE, Place(file=file, line=1)))
        for named, line in launch.interpreters:
            match = None if _below(named, evidence) else _PYTHON.fullmatch(named)
            if match and (python := _meant(match[1], ubuntu, alone=False)):
                found.setdefault(named, (python, _BY_IT, Place(file=launch.file, line=line)))
    reasons = tuple(
        because("workspace", name, f"{why}: {_LEADS}", place, weight=LINKED) for name, (_, why, place) in found.items()
    )
    return Choice(answer=tuple((name, python) for name, (python, _, _) in found.items()), reasons=reasons)


def _below(path: str, evidence: Evidence) -> bool:
    return any(each.prefix and path.startswith(f"{each.prefix}/") for each in evidence.author_paths)


def _meant(name: str, ubuntu: str | None, *, alone: bool) -> str:
    """Return the image's Python that stands for one of a name, ``""`` for none.

    Where ROS has Python 2, a program for Python 3 can do without only if it imports nothing of ROS, and with the
    Ubuntu's own version.
    """
    if ubuntu not in ubuntus_with_python2():
        return "python3"
    if not name.startswith("python3"):
        return "python2"
    return "python3" if alone and name in {"python3", f"python{python_of_ubuntu().get(ubuntu or '')}"} else ""
