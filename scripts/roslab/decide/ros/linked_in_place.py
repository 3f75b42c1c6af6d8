"""Folders beside the packages of a workspace whose libraries a package links by their file, where they are compiled.

``target_link_libraries(node ${CMAKE_CURRENT_SOURCE_DIR}/../lib/build/libx.a)``: no build tool of ROS makes that file.
"""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.ros.workspace import packages_of
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Evidence
from roslab.values.origin import Place

BUILD = "build"
"""The folder that CMake is called in."""


def linked_files(evidence: Evidence) -> Iterator[tuple[str, Place]]:
    """Yield each file that a package of the workspace links and the tree lacks, with the call that does."""
    packages = {manifest.file.rpartition("/")[0] for manifest in packages_of(evidence).built}
    for project in evidence.cmake:
        if project.file.rpartition("/")[0] in packages:
            yield from ((path, Place(file=project.file, line=line)) for path, line in project.linked)


def linked_in_place(evidence: Evidence) -> Iterator[tuple[CMakeProject, str, Place]]:
    """Yield each project of plain CMake, beside the packages, in whose ``build`` such a file is."""
    tops = {each.file.rpartition("/")[0]: each for each in evidence.cmake if each.top_level and not each.added}
    found: dict[str, tuple[CMakeProject, str, Place]] = {}
    for path, place in linked_files(evidence):
        for folder in _before(path):
            if folder in tops:
                found.setdefault(folder, (tops[folder], path, place))
    for folder, each in found.items():
        packages = (manifest.file for manifest in evidence.manifests)
        if not any(package.startswith(f"{folder}/") for package in packages):
            yield each


def _before(path: str) -> Iterator[str]:
    """Yield the folders below which a path goes through a folder ``build``."""
    end = path.find(f"/{BUILD}/")
    while end > 0:
        yield path[:end]
        end = path.find(f"/{BUILD}/", end + 1)
