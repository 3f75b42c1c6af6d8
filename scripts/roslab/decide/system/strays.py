"""CMake projects without a package.xml that colcon would build, and that nothing brings what they require."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from roslab.config.model import BuildTool
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.nothing_to_build import Built
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.left_out import SOURCE
from roslab.decide.system.names import Target, resolve
from roslab.decide.system.required import Outside, provided_as
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Evidence
from roslab.values.words import line_of

_TOLD = (
    "nothing is known that brings {1}, which CMake requires in {0}, a project without a package.xml that colcon would "
    "build with the packages: the folder is left out of the build; {2}"
)


def strays(
    evidence: Evidence, packages: Packages, target: Target, names: Collection[str], build_tool: BuildTool
) -> Iterator[tuple[str, Warning_]]:
    """Yield the folder of each such project with what is told of it; ``names`` are those that are brought.

    Not of one that others of the tree need: the build stops there, as it does without what it requires.
    """
    if build_tool != "colcon" or not packages.built:
        return
    lacking, built, askers = Outside(evidence, packages), Built(packages), _askers(evidence)
    for project in evidence.cmake:
        folder = project.file.rpartition("/")[0]
        if not _taken(project, folder) or not built.outside(folder) or _needed(project, askers):
            continue
        for asked in lacking.of(project):
            if not (resolve(asked, target).known or provided_as(asked.name, names)):
                yield folder, warn(_TOLD.format(folder, asked.name, SOURCE), asked)
                break


def spare_projects(
    evidence: Evidence,
    packages: Packages,
    build_tool: BuildTool,
    command: tuple[str, ...] | str,
    left_out: Collection[str],
) -> tuple[str, ...]:
    """Return the folders of such projects that are built as far as they can be: nothing of the tree needs them.

    Not that whose program the command starts, nor what is left out anyway.
    """
    if build_tool != "colcon" or not packages.built:
        return ()
    built, askers = Built(packages), _askers(evidence)
    started = {word.rpartition("/")[2] for word in line_of(command).split()}
    found = set()
    for project in evidence.cmake:
        folder = project.file.rpartition("/")[0]
        if folder in left_out or not _taken(project, folder) or not built.outside(folder):
            continue
        if not (_needed(project, askers) or started & {name.rpartition("/")[2] for name, _ in project.executables}):
            found.add(folder)
    return tuple(sorted(found))


def _taken(project: CMakeProject, folder: str) -> bool:
    """Tell whether colcon takes a folder for a package: one that calls ``project()``, in no hidden or marked folder."""
    seen = not project.ignored and not any(part.startswith(".") for part in folder.split("/"))
    return seen and project.top_level and bool(project.name)


def _askers(evidence: Evidence) -> Mapping[str, Collection[str]]:
    """Return the files of projects and manifests that ask for a name, by the name."""
    files: dict[str, set[str]] = {}
    asking = [(each.file, each.dependencies) for each in evidence.cmake]
    asking += [(each.file, each.dependencies) for each in evidence.manifests]
    for file, dependencies in asking:
        for asked in dependencies:
            files.setdefault(plain(asked.name), set()).add(file)
    return files


def _needed(project: CMakeProject, askers: Mapping[str, Collection[str]]) -> bool:
    """Tell whether another project or a manifest asks for it; CMake finds ``mylib-config.cmake`` as ``MyLib``, too."""
    made = {plain(name) for name in (project.name, *project.configs, *project.targets) if name}
    return any(file != project.file for name in made for file in askers.get(name, ()))
