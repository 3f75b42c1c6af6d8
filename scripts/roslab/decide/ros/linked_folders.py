"""Libraries that CMake links by their bare names and only a package of ROS has, in a folder no linker searches."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import distro
from roslab.knowledge.libraries import library
from roslab.knowledge.released import released
from roslab.knowledge.table import rows

_NAME = "LIBRARY_PATH"
"""Searched by the linker last; ROS sets what is searched at run time alone.
https://gcc.gnu.org/onlinedocs/gcc/Environment-Variables.html, read 2026-11-27."""


def linked_folders(evidence: Evidence, ros: str | None) -> Iterator[tuple[str, str, str, Dependency]]:
    """Yield the variable that tells the linker the folder of ROS's libraries, why it is set, and what needs it.

    A library is one of such a package if it begins with the name by which its CMake requires that: ``g2o_core``. The
    configuration files of some packages give such names themselves.
    """
    known = distro(ros)
    if known is None:
        return
    there = released(known.name)
    bare = {row["name"]: row["package"] for row in rows("linked_by_bare_names") if row["package"] in there}
    for project in evidence.cmake:
        of_ros = [
            each.name
            for each in project.dependencies
            if each.namespace == "cmake" and _only_of_ros(each.name, known.name) and not places.aside(each.file)
        ]
        for each in project.dependencies if of_ros else ():
            package = next((name for name in of_ros if each.name.startswith(f"{name.lower()}_")), "")
            if package and each.namespace == "link" and not library("link", each.name, None):
                why = f"CMake links {each.name} by its name, which only ROS's {package} has"
                yield _NAME, f"/opt/ros/{known.name}/lib", why, each
                return
        for asked in project.dependencies:
            package = bare.get(asked.name, "") if asked.namespace == "cmake" and not places.aside(asked.file) else ""
            if package:
                why = f"the libraries of {asked.name}, which only ROS's {package} has, are linked by bare names"
                yield _NAME, f"/opt/ros/{known.name}/lib", why, asked
                return


def _only_of_ros(name: str, ros: str) -> bool:
    found = library("cmake", name, None)
    return found is not None and bool(found.ros) and not found.apt and found.ros in released(ros)
