"""Interpreters of the author's machine in first lines of scripts: links in their places lead to the image's Python."""

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
_PYTHON = pattern(r"(?!/root/)(?:/(?!\.\.?/)[\w.+@-]+)+/(python[\d.]*)")
"""The path of a Python; the image's user cannot look into ``/root``."""


def decide_interpreters(evidence: Evidence, config: Config, ubuntu: str | None) -> Choice[tuple[tuple[str, str], ...]]:
    """Return the paths that first lines of what launch files start name, each with the program that is meant."""
    if config.compatible:
        return Choice(answer=())
    found: dict[str, tuple[str, Place]] = {}
    for launch in evidence.launch:
        for file, named in launch.foreign:
            match = _PYTHON.fullmatch(named)
            if match and (python := _meant(match[1], ubuntu, alone=file in launch.without_ros)):
                found.setdefault(named, (python, Place(file=file, line=1)))
    why = "launch files start scripts whose first line names it: a link there leads to the image's Python"
    reasons = tuple(because("workspace", name, why, place, weight=LINKED) for name, (_, place) in found.items())
    return Choice(answer=tuple((name, python) for name, (python, _) in found.items()), reasons=reasons)


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
