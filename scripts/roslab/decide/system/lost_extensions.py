"""What a project that pip compiles requires and nothing brings: by its CMake, or by the headers of its sources."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.python.at_top import started_files
from roslab.decide.python.may_bring import absent
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.left_out import SOURCE
from roslab.decide.system.library_headers import is_known, may_bring, named
from roslab.decide.system.names import Target, resolve
from roslab.decide.system.required import by_pip, similar
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.python_project import PythonProject
from roslab.knowledge.frameworks import imports
from roslab.knowledge.wheel_headers import wheel_headers

Lost = tuple[PythonProject, Dependency]
"""A project, and what its CMake requires (``cmake``) or its sources include (``include``)."""


def lost_extensions(
    evidence: Evidence, packages: Packages, target: Target, provided: Iterable[str], *, unread: bool
) -> Iterator[Lost]:
    """Yield each project with what stops it; ``provided``: names of everything that the image has.

    A command of roslab.yaml or a submodule that is not there, which is ``unread``, may bring any header.
    """
    names = {plain(name) for name in provided}
    for project, asked in by_pip(evidence, packages):
        if not resolve(asked, target).known and not similar(plain(asked.name), names):
            yield project, asked
    if unread or absent(evidence):
        return
    projects = {each.folder: each for each in evidence.python if each.installable}
    there: set[str] = set()
    for said in (each for each in evidence.mentions if each.topic == "lost_header" and each.inside in projects):
        project, folder = projects[said.inside], said.value.partition("/")[0]
        asked = Dependency(namespace="include", name=said.value, strength="used", file=said.file, line=said.line)
        there = there or {*names, *named(evidence), *(plain(e.key) for p in evidence.python for e in p.build_requires)}
        of_package = folder in imports() or folder in wheel_headers()
        if not (of_package or is_known(asked, folder) or may_bring(plain(folder), there)):
            yield project, asked


def may_stop(lost: Collection[Lost], evidence: Evidence, command: tuple[str, ...] | str) -> tuple[str, ...]:
    """Return the folders of the projects at which pip may stop: none of which the command imports what is compiled."""
    needed = _needed(lost, evidence, command)
    stopping = {project.folder for project, asked in lost if _used(project, asked, needed)}
    return tuple(dict.fromkeys(project.folder for project, _ in lost if project.folder not in stopping))


def told(lost: Collection[Lost], evidence: Evidence, command: tuple[str, ...] | str) -> tuple[Warning_, ...]:
    """Return a warning for each name."""
    needed = _needed(lost, evidence, command)
    first: dict[str, Lost] = {each[1].name: each for each in reversed([*lost])}
    return tuple(_told(project, asked, _used(project, asked, needed)) for project, asked in first.values())


def _needed(lost: Collection[Lost], evidence: Evidence, command: tuple[str, ...] | str) -> list[Mention]:
    """Return where the files that the command starts, or modules that these import, import what is compiled."""
    started = {*started_files(command, evidence)} if lost else set[str]()
    return [each for each in evidence.mentions if each.topic == "needs_extension" and each.inside in started]


def _used(project: PythonProject, asked: Dependency, needed: Collection[Mention]) -> Mention | None:
    return next((each for each in needed if _of(project, each)), None) if asked.namespace == "include" else None


def _of(project: PythonProject, used: Mention) -> bool:
    """Tell whether a module that a program imports is most likely compiled by a project: its file lies in there."""
    return not project.folder or used.file.startswith(f"{project.folder}/") or project.name == used.value.split(".")[0]


def _told(project: PythonProject, asked: Dependency, used: Mention | None) -> Warning_:
    name = project.name or "the project"
    if asked.namespace != "include":
        stops = f"pip will stop at {name}, and only what that requires is installed"
        return warn(f"nothing is known that brings {asked.name}, which CMake requires: {stops}; {SOURCE}", asked)
    what = f"the extension of {name} includes {asked.name}, and nothing is known that brings it"
    then = "give its package under `apt` or its repository under `source` in roslab.yaml"
    if used:
        why = f"the command imports {used.value} of it ({used.file}:{used.line})"
        return warn(f"{what}: the build will stop there, for {why}; {then}", asked)
    stops = "where pip stops there, its modules of Python are on the path, and what it requires is installed"
    return warn(f"{what}: {stops}; {then}", asked)
