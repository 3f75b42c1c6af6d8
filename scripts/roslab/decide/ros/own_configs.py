"""Projects of plain CMake in the tree that its packages find, or whose libraries they link, once they are installed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from roslab.decide.ros.workspace import packages_of
from roslab.decide.system.names import Target, resolve
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace


def installing(evidence: Evidence) -> dict[str, CMakeProject]:
    """Return the projects that install a file for find_package, by the lower-cased names of what it finds there."""
    found: dict[str, CMakeProject] = {}
    for project, top in _plain(evidence):
        for name in project.configs:
            found.setdefault(name.lower(), top)
    return found


def _plain(evidence: Evidence) -> Iterator[tuple[CMakeProject, CMakeProject]]:
    """Yield each CMakeLists.txt of a project that is no package, with the one at the project's top."""
    packages = {manifest.file.rpartition("/")[0] for manifest in evidence.manifests}
    tops = {each.file.rpartition("/")[0]: each for each in evidence.cmake if each.top_level and each.name}
    for project in evidence.cmake:
        top = tops.get(project.top)
        if top and project.top not in packages and not places.sample(top.file):
            yield project, top


def required_of_tree(evidence: Evidence, target: Target) -> Iterator[tuple[CMakeProject, Dependency]]:
    """Yield each such project with what requires it: a package of the workspace. Not one of what Ubuntu or ROS has.

    Where it installs no file for find_package, a package may name its library alone.
    """
    here = installing(evidence)
    libraries = {name: top for project, top in _plain(evidence) for name in project.installs}
    folders = _built(evidence) if here or libraries else set()
    found: dict[str, tuple[CMakeProject, Dependency]] = {}
    for project in evidence.cmake if folders else ():
        if project.file.rpartition("/")[0] not in folders:
            continue
        for asked in project.dependencies:
            there = here.get(asked.name.lower()) if asked.namespace == "cmake" and asked.role != "test" else None
            if there and asked.strength == "declared" and not resolve(asked, target).known:
                found.setdefault(there.file, (there, asked))
        for top, asked in _linked(project, libraries):
            if not resolve(asked, target).known:
                found.setdefault(top.file, (top, replace(asked, required=True)))
    yield from found.values()


def linked_of_tree(evidence: Evidence) -> frozenset[str]:
    """Return the libraries of such projects that packages of the workspace link, and what their projects are called."""
    tops = {name: top for project, top in _plain(evidence) for name in project.installs}
    folders = _built(evidence) if tops else set()
    built = [project for project in evidence.cmake if project.file.rpartition("/")[0] in folders]
    found = [(top, asked) for project in built for top, asked in _linked(project, tops)]
    return frozenset(name for top, asked in found for name in (top.name, asked.name) if name)


def _linked(project: CMakeProject, libraries: Mapping[str, CMakeProject]) -> Iterator[tuple[CMakeProject, Dependency]]:
    """Yield what a package always links of these, and does not make itself; not what is made only for tests."""
    for asked in project.dependencies:
        top = libraries.get(asked.name) if asked.namespace == "link" and asked.role == "build" else None
        if top and asked.strength == "used" and not top.lacks and asked.name not in project.made:
            yield top, asked


def _built(evidence: Evidence) -> set[str]:
    return {manifest.file.rpartition("/")[0] for manifest in packages_of(evidence).built}
