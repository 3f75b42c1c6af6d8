"""Packages behind a condition of CMake that the build needs all the same: for the program that it runs, for its ROS."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

from roslab.config.model import Kind
from roslab.decide.launched_windows import files_of_nodes
from roslab.decide.programs import compiled
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.lex.truth import workspace_holds
from roslab.evidence.prose.called_in_scripts import IN_SCRIPT
from roslab.evidence.roles import LATEX
from roslab.values.dataclass import replace

_OF_COMMAND = frozenset({IN_SCRIPT, LATEX})


def required_by_command(evidence: Evidence, command: tuple[str, ...] | str, kind: Kind) -> Evidence:
    """Return the evidence with what guards the command's program as needed: ``if(X_FOUND) add_executable(…)``.

    What guards every program of a C++ project is needed as well: without it none is compiled. What shell scripts call,
    and LaTeX, are needed of the command's own alone.
    """
    words = command.split() if isinstance(command, str) else command
    if any(each.role in _OF_COMMAND for each in evidence.code):
        its_own = starts(evidence, command)
        code = tuple(each for each in evidence.code if each.role not in _OF_COMMAND or its_own(each.file))
        evidence = replace(evidence, code=code)
    started = {word.rpartition("/")[2] for word in words}
    everywhere = _of_all_programs(evidence) if kind in {"cpp", "cuda"} else frozenset()
    if not everywhere and not any(program in started for project in evidence.cmake for program, _ in project.guards):
        return evidence
    return replace(evidence, cmake=tuple(_required(project, started, everywhere) for project in evidence.cmake))


def starts(evidence: Evidence, command: tuple[str, ...] | str) -> Callable[[str], bool]:
    """Return what tells whether a command names a file of the tree, or starts it as a node in Python."""
    words = command.split() if isinstance(command, str) else command
    nodes = files_of_nodes(evidence, command) if command and not isinstance(command, str) else frozenset()
    return lambda file: file in nodes or runs(words, file)


def runs(words: Sequence[str], file: str) -> bool:
    """Tell whether the words of a command, or of the line that a shell is given, name a file of the tree.

    Also by the module that ``python -m`` starts.
    """
    said = [path for word in words for path in word.split()]
    modules = (f"{name.replace('.', '/')}.py" for before, name in pairwise(said) if before == "-m")
    paths = (path.removeprefix("./") for path in (*said, *modules))
    return any(path and (file == path or file.endswith(f"/{path}")) for path in paths)


def _of_all_programs(evidence: Evidence) -> frozenset[str]:
    """Return the packages, in lower case, without which no program of the project is compiled, examples aside."""
    if not any(project.guards for project in evidence.cmake):
        return frozenset()
    guards = {project.file: project.guards for project in evidence.cmake}
    programs = [program for program in compiled(evidence) if not places.sample(program.file)]
    found = [{package for name, package in guards[each.file] if name == each.name} for each in programs]
    return frozenset(set.intersection(*found)) if found else frozenset()


def required_by_tool(evidence: Evidence, kind: Kind) -> Evidence:
    """Return the evidence with what CMake requires where the build tool decides its condition: ``if(catkin_FOUND)``."""
    if kind not in {"ros1", "ros2"}:
        return evidence
    ros = 1 if kind == "ros1" else 2
    if not any(_stops(each, ros) for project in evidence.cmake for each in project.dependencies):
        return evidence
    return replace(evidence, cmake=tuple(_stopping(project, ros) for project in evidence.cmake))


def _stopping(project: CMakeProject, ros: int) -> CMakeProject:
    found = (replace(each, strength="declared") if _stops(each, ros) else each for each in project.dependencies)
    return replace(project, dependencies=tuple(found))


def _stops(asked: Dependency, ros: int) -> bool:
    if not asked.required or asked.strength != "optional" or not asked.condition:
        return False
    return workspace_holds(asked.condition, ros) is True


def _required(project: CMakeProject, started: set[str], everywhere: frozenset[str]) -> CMakeProject:
    needed = everywhere | {package for program, package in project.guards if program in started}
    return replace(
        project,
        dependencies=tuple(
            replace(each, strength="used")
            if each.namespace == "cmake" and each.strength == "optional" and each.name.lower() in needed
            else each
            for each in project.dependencies
        ),
    )
