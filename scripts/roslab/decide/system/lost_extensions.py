"""What the CMake of a project that pip compiles requires and nothing brings."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.left_out import SOURCE
from roslab.decide.system.names import Target, resolve
from roslab.decide.system.required import by_pip, similar
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.python_project import PythonProject


def lost_extensions(
    evidence: Evidence, packages: Packages, target: Target, provided: Iterable[str]
) -> Iterator[tuple[PythonProject, Dependency]]:
    """Yield each project with what stops it; ``provided``: names of everything that the image has."""
    names = {plain(name) for name in provided}
    for project, asked in by_pip(evidence, packages):
        if not resolve(asked, target).known and not similar(plain(asked.name), names):
            yield project, asked


def told(lost: Iterable[tuple[PythonProject, Dependency]]) -> Iterator[Warning_]:
    """Yield a warning for each name."""
    for project, asked in {each[1].name: each for each in reversed([*lost])}.values():
        stops = f"pip will stop at {project.name or 'the project'}, and only what that requires is installed"
        yield warn(f"nothing is known that brings {asked.name}, which CMake requires: {stops}; {SOURCE}", asked)
