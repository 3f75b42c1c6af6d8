"""Packages that a build takes if they are there, and without which it leaves out the program that the image runs."""

from __future__ import annotations

from roslab.evidence.facts import CMakeProject, Evidence
from roslab.values.dataclass import replace


def required_by_command(evidence: Evidence, command: tuple[str, ...] | str) -> Evidence:
    """Return the evidence with what guards the command's program as needed: ``if(X_FOUND) add_executable(…)``."""
    words = command.split() if isinstance(command, str) else command
    started = {word.rpartition("/")[2] for word in words}
    if not any(program in started for project in evidence.cmake for program, _ in project.guards):
        return evidence
    return replace(evidence, cmake=tuple(_required(project, started) for project in evidence.cmake))


def _required(project: CMakeProject, started: set[str]) -> CMakeProject:
    needed = {package for program, package in project.guards if program in started}
    return replace(
        project,
        dependencies=tuple(
            replace(each, strength="used")
            if each.namespace == "cmake" and each.strength == "optional" and each.name.lower() in needed
            else each
            for each in project.dependencies
        ),
    )
