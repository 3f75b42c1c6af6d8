"""Packages of plain CMake: those beside each other, which only colcon builds together, and one that names catkin."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.config.model import WORKSPACE_TOOLS
from roslab.decide.programs import top_of
from roslab.decide.ros.workspace import packages_of
from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Evidence, Mention, PackageManifest

FEWEST = 2
"""A single package is built by CMake alone."""


def built_together(evidence: Evidence) -> Mention | None:
    """Return where a page runs colcon on several packages without a CMakeLists.txt above them, else ``None``."""
    said = (m for m in evidence.mentions if m.topic == "build_tool" and m.value == "colcon" and m.source == "readme")
    apart = [manifest for manifest in packages_of(evidence).built if "/" in manifest.file]
    if len(apart) < FEWEST or any(project.file == "CMakeLists.txt" for project in evidence.cmake):
        return None
    return next(said, None)


def built_by_cmake_alone(evidence: Evidence, made: list[PackageManifest]) -> bool:
    """Tell whether the only package is the root, whose CMake calls nothing of ROS, and the page builds by CMake alone.

    Many libraries have a package.xml for ROS's build farm, which names catkin and is not meant for it.
    """
    top = top_of(evidence)
    if top is None or [manifest.file for manifest in made] != ["package.xml"] or "/" in top.file:
        return False
    said = {m.value for m in evidence.mentions if m.topic == "build_tool" and m.source == "readme"}
    return not {"catkin", "ament"} & {*top.macros} and "cmake" in said and said.isdisjoint(WORKSPACE_TOOLS)


def parts_of_cmake(evidence: Evidence, listed: Sequence[GitSource]) -> bool:
    """Tell whether a list adds to one project of plain CMake: each repository into a folder with parts of that project.

    ``extensions/udp`` beside ``extensions/pcl/CMakeLists.txt`` is such a part.
    """
    roots = [project for project in evidence.cmake if "/" not in project.file]
    if not roots or any({"catkin", "ament", "rosbuild"} & {*project.macros} for project in roots):
        return False
    folders = {project.file.partition("/")[0] for project in evidence.cmake if "/" in project.file}
    return all("/" in source.name and source.name.partition("/")[0] in folders for source in listed)
