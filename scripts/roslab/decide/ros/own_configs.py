"""Projects of plain CMake in the tree that its packages find once they are installed."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.ros.workspace import packages_of
from roslab.decide.system.names import Target, resolve
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence


def installing(evidence: Evidence) -> dict[str, CMakeProject]:
    """Return the projects that install a file for find_package, by the lower-cased names of what it finds there."""
    packages = {manifest.file.rpartition("/")[0] for manifest in evidence.manifests}
    tops = {each.file.rpartition("/")[0]: each for each in evidence.cmake if each.top_level and each.name}
    found: dict[str, CMakeProject] = {}
    for project in evidence.cmake:
        top = tops.get(project.top)
        if top and project.top not in packages and not places.sample(top.file):
            for name in project.configs:
                found.setdefault(name.lower(), top)
    return found


def required_of_tree(evidence: Evidence, target: Target) -> Iterator[tuple[CMakeProject, Dependency]]:
    """Yield each such project with what requires it: a package of the workspace. Not one of what Ubuntu or ROS has."""
    here = installing(evidence)
    folders = {manifest.file.rpartition("/")[0] for manifest in packages_of(evidence).built} if here else set()
    found: dict[str, tuple[CMakeProject, Dependency]] = {}
    for project in evidence.cmake if here else ():
        if project.file.rpartition("/")[0] not in folders:
            continue
        for asked in project.dependencies:
            there = here.get(asked.name.lower()) if asked.namespace == "cmake" and asked.role != "test" else None
            if there and asked.strength == "declared" and not resolve(asked, target).known:
                found.setdefault(there.file, (there, asked))
    yield from found.values()
