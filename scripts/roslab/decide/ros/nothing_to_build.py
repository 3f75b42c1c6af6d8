"""Folders that a tool of ROS takes for packages, and in which there is nothing that it could build: it stops there."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import BuildTool
from roslab.decide.ros.workspace import Packages, nothing_builds, types
from roslab.evidence import places
from roslab.evidence.facts import Evidence

_BUILT = frozenset({"ament_cmake", "ament_python", "catkin", "cmake"})
"""Build types that need a CMakeLists.txt or a setup.py; for others a tool may have an extension."""


def nothing_to_build(evidence: Evidence, packages: Packages, build_tool: BuildTool) -> tuple[str, ...]:
    """Return these folders: the share folders of installed packages, and for colcon CMake projects without their code.

    colcon takes each CMakeLists.txt that calls ``project()`` for a package. Not the root, nor what holds or lies in a
    package that is built, where the marker would hide that or no tool looks.
    https://colcon.readthedocs.io/en/released/reference/discovery-arguments.html
    """
    found = {*_described(evidence, packages), *(_without_code(evidence) if build_tool == "colcon" else ())}
    built = Built(packages)
    return tuple(sorted(filter(built.outside, found - set(packages.doubles))))


class Built:
    """The folders of the packages that are built."""

    def __init__(self, packages: Packages) -> None:
        self._folders = {manifest.file.rpartition("/")[0] for manifest in packages.built}
        self._holding = {above for folder in self._folders for above in _around(folder)}

    def outside(self, folder: str) -> bool:
        """Tell whether a folder neither holds nor lies in a package that is built; the root holds all."""
        return bool(folder) and folder not in self._holding and places.innermost(folder, self._folders) is None


def _around(folder: str) -> Iterator[str]:
    while folder := folder.rpartition("/")[0]:
        yield folder


def _described(evidence: Evidence, packages: Packages) -> Iterator[str]:
    """Yield the folders of manifests beside which nothing is."""
    by_cmake = {project.file.rpartition("/")[0] for project in evidence.cmake}
    buildable = by_cmake | {project.folder for project in evidence.python}
    for manifest in packages.assets:
        folder = manifest.file.rpartition("/")[0]
        known = types(manifest) <= _BUILT
        if known and not manifest.metapackage and (folder not in buildable or nothing_builds(manifest, by_cmake)):
            yield folder


def _without_code(evidence: Evidence) -> Iterator[str]:
    """Yield the folders of CMake projects without a manifest that have none of the files which they compile."""
    manifests = {manifest.file.rpartition("/")[0] for manifest in evidence.manifests}
    for project in evidence.cmake:
        folder = project.file.rpartition("/")[0]
        if project.top_level and project.lacks and folder not in manifests:
            yield folder
