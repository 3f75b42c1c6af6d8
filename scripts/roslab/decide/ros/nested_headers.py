"""Headers that older distributions of ROS 2 had in one folder for all packages, and newer ones in one for each."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.system.names import spellings
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import distro
from roslab.knowledge.header_only import header_only
from roslab.knowledge.released import released

_NAME = "CPLUS_INCLUDE_PATH"
"""Searched last, so that a package of the workspace comes before the one in /opt/ros.
https://gcc.gnu.org/onlinedocs/gcc/Environment-Variables.html, read 2026-11-26."""


def nested_headers(evidence: Evidence, ros: str | None) -> Iterator[tuple[str, str, str, Dependency]]:
    """Yield the variable that tells the folders of header-only packages which a package includes and never finds.

    Each with its value, why it is set, and the first include that needs it.
    """
    known = distro(ros)
    if known is None or known.ros != 2:
        return
    found = {
        project.file.rpartition("/")[0]: {d.name for d in project.dependencies if d.namespace == "cmake"}
        for project in evidence.cmake
    }
    folders: dict[str, Dependency] = {}
    for row in header_only():
        first = distro(row.since)
        if first is None or known.released < first.released:
            continue
        for each in evidence.code:
            if each.namespace != "include" or not each.name.startswith(f"{row.package}/") or places.aside(each.file):
                continue
            by = next((found[folder] for folder in _folders(each.file) if folder in found), None)
            told = by is None or "rclcpp" not in by  # ament_cmake_auto finds what package.xml names
            if told or any(name == row.package or name.startswith(f"{row.package}_") for name in by or ()):
                continue
            for package in (row.package, *row.includes):
                folders.setdefault(f"/opt/ros/{known.name}/include/{package}", each)
            break
    for each in _of_plain_cmake(evidence, known.name):
        folders.setdefault(f"/opt/ros/{known.name}/include", each)
    if folders:
        asked = next(iter(folders.values()))
        package = asked.name.partition("/")[0].partition(".")[0]
        why = f"{asked.name} is in a folder of its package alone, and CMake does not find {package}"
        yield _NAME, ":".join(folders), why, asked


def _of_plain_cmake(evidence: Evidence, ros: str) -> Iterator[Dependency]:
    """Yield the includes of a package that CMake finds by a name of its own: ``Fields2Cover``, ``fields2cover.h``.

    It is none of ament, whose call for dependencies tells no folder of it then, and has its headers beside all others.
    """
    for project in evidence.cmake:
        named = [d.name for d in project.dependencies if d.namespace == "cmake" and d.name not in released(ros)]
        packages = {each for name in named for each in spellings(name) if each in released(ros)}
        folder = project.file.rpartition("/")[0]
        for each in evidence.code if packages else ():
            inside = each.namespace == "include" and folder in _folders(each.file)
            if inside and each.name.partition("/")[0].partition(".")[0].lower() in packages:
                yield each


def _folders(file: str) -> Iterator[str]:
    """Yield the folders that a file is in, its own first; ``""`` is the root."""
    while file:
        file = file.rpartition("/")[0]
        yield file
