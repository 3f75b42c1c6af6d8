"""Projects of Python whose extension cannot be compiled here: what they require is installed all the same."""

from __future__ import annotations

from collections.abc import Collection

from roslab.decide.decision import Choice
from roslab.decide.python.image_python import Python
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace


def with_lost_extensions(choice: Choice[Python], folders: Collection[str], evidence: Evidence) -> Choice[Python]:
    """Add what the projects of these folders require, which pip installs where it stops at them.

    ``folders``: of those whose CMake requires what nothing brings. Only what the image installs is such a project.
    """
    lost = []
    for project in evidence.python:
        folder = project.folder or "."
        if project.folder in folders and folder in choice.answer.projects:
            asked = (each for each in project.requirements if each.role == "" and each.name)
            lost.append((folder, tuple(each for each in asked if choice.answer.interpreter.may(each))))
    return replace(choice, answer=replace(choice.answer, lost_extensions=tuple(lost))) if lost else choice
