"""Packages of plain CMake: those that only colcon builds together, and those that name catkin, or need it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cache

from roslab.config.model import WORKSPACE_TOOLS
from roslab.decide.programs import top_of
from roslab.decide.ros.workspace import packages_of, types
from roslab.evidence import places
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence, Mention, PackageManifest
from roslab.knowledge.carried import base_holds
from roslab.knowledge.distros import distros
from roslab.knowledge.libraries import library
from roslab.knowledge.released import released, rosdep_keys

FEWEST = 2
"""A single package is built by CMake alone."""


def built_together(evidence: Evidence) -> Mention | None:
    """Return where a page runs colcon on several packages without a CMakeLists.txt above them, else ``None``."""
    said = (m for m in evidence.mentions if m.topic == "build_tool" and m.value == "colcon" and m.source == "readme")
    apart = [manifest for manifest in packages_of(evidence).built if "/" in manifest.file]
    if len(apart) < FEWEST or any(project.file == "CMakeLists.txt" for project in evidence.cmake):
        return None
    return next(said, None)


def beside_catkin(evidence: Evidence) -> tuple[Dependency, bool] | None:
    """Return what a package of plain CMake needs that ROS 1 alone brings, and whether its CMake stops without it.

    That it is for a workspace of catkin is said by what every such package names (REP 136: catkin, as needed to run):
    it then needs any package that only ROS releases. One that names no catkin needs one of ROS 1's own, which no ROS 2
    has, and its CMake stops without it. https://ros.org/reps/rep-0136.html
    """
    plain = [m for m in packages_of(evidence).built if types(m) == {"cmake"} and not places.aside(m.file)]
    for manifest in plain:
        folder = manifest.file.rpartition("/")[0]
        file = f"{folder}/CMakeLists.txt".lstrip("/")
        asked = [d for project in evidence.cmake if project.file == file for d in project.dependencies if _always(d)]
        said = any(d.name == "catkin" and d.role == "exec" and not d.condition for d in manifest.dependencies)
        names = _of_ros() if said else of_one_ros_alone(1)
        if found := next(_among(asked, names), None):
            return found, True
        needs = [d for d in manifest.dependencies if d.role in {"build", "exec"} and not d.condition]
        if said and (found := next(_among(needs, names), None)):
            return found, False
    return None


def _always(asked: Dependency) -> bool:
    return asked.namespace in {"cmake", "ros"} and asked.strength == "declared" and not asked.condition


def _among(asked: Iterable[Dependency], names: frozenset[str]) -> Iterator[Dependency]:
    """Yield what is one of some packages of ROS, and nothing that Ubuntu has; any library may name catkin itself."""
    for each in asked:
        known = library("cmake", each.name, None)
        if each.name in names and each.name != "catkin" and not (known and known.apt):
            yield each


@cache
def _of_ros() -> frozenset[str]:
    """Return the packages that a distribution of ROS 1 released, and rosdep knows by no other name."""
    return frozenset().union(*(released(each.name) for each in distros().values() if each.ros == 1)) - rosdep_keys()


@cache
def of_one_ros_alone(version: int) -> frozenset[str]:
    """Return the packages that every image of that ROS has, and no distribution of the other ever released."""
    return base_holds(version) - frozenset().union(*(released(d.name) for d in distros().values() if d.ros != version))


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
