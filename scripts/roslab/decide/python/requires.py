"""The Pythons that projects of the tree require: pip refuses to install a project on any other, and the build stops."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.decide.decision import Reason, Warning_
from roslab.decide.python.pythons import PREFERRED
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence
from roslab.evidence.python_project import PythonProject
from roslab.values.specifier import admits, specifiers


def required(evidence: Evidence, projects: Iterable[PythonProject] = ()) -> tuple[PythonProject, ...]:
    """Return the project at the root, if pip can install it, and those of ``projects`` that say what they require."""
    own = [each for each in evidence.python if not each.folder and each.installable]
    return tuple(each for each in dict.fromkeys((*own, *projects)) if each.requires_python)


def refusing(python: str, projects: Iterable[PythonProject]) -> PythonProject | None:
    """Return the first of these projects that pip refuses to install on a Python, ``None`` if it takes all."""
    for each in projects:
        allowed = specifiers(each.requires_python) if each.requires_python else None
        if allowed is not None and not admits(allowed, python):
            return each
    return None


def able(named: Iterable[Reason], projects: Iterable[PythonProject], made: str | None = None) -> tuple[Reason, ...]:
    """Return the reasons for a version on which pip can install all projects, and that of the environment ``made``.

    A project that contradicts those before it is passed over: no Python suits both.
    """
    pythons = list(PREFERRED)
    agreeing: list[PythonProject] = []
    for project in projects:
        if narrower := [python for python in pythons if refusing(python, (project,)) is None]:
            pythons, agreeing = narrower, [*agreeing, project]
    return tuple(each for each in named if refusing(each.answer, agreeing) is None or (made and each.file == made))


def refused_python(python: str | None, projects: Iterable[PythonProject]) -> Iterator[Warning_]:
    """Yield a warning for each project that the image installs and whose requirement its Python does not meet."""
    if python is None:
        return
    for each in projects:
        if refusing(python, (each,)):
            name = each.name or each.folder or "the project"
            message = f"{name} requires Python {each.requires_python}, and the image has {python}: pip does not install"
            yield warn(
                f"{message} it there; `base.python` in roslab.yaml names another, where the base allows it", each
            )
