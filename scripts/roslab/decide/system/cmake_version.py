"""Which CMake version the build asks for, and whether the Ubuntu has it."""

from __future__ import annotations

from packaging.version import Version

from roslab.config.model import Kind
from roslab.decide.ros.workspace import packages_of
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import cmake_of_ubuntu
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated


def needed_cmake(evidence: Evidence) -> Dependency | None:
    """Return the highest version that any CMakeLists.txt of the build requires, with the line that requires it."""
    folders = {manifest.file.rpartition("/")[0] for manifest in packages_of(evidence).built}
    demands = [
        project.minimum
        for project in evidence.cmake
        if project.minimum
        and (project.file.rpartition("/")[0] in folders or (not folders and project.top_level))
        and not (places.vendored(project.file) or places.example(project.file) or places.test(project.file))
    ]
    return max(demands, key=lambda demand: Version(demand.version or "0"), default=None)


def has_it(ubuntu: str, demand: Dependency | None) -> bool:
    """Tell whether an Ubuntu's own CMake is new enough."""
    return demand is None or Version(cmake_of_ubuntu()[ubuntu]) >= Version(demand.version or "0")


def from_pip(evidence: Evidence, kind: Kind, ubuntu: str | None) -> Requirement | None:
    """Return CMake as a pip requirement if the Ubuntu's is too old, below the next major version.

    CMake 4 refuses projects that ask for a version before 3.5, and a dependency of the repository may be one of them.
    """
    demand = needed_cmake(evidence) if kind != "python" else None
    if demand is None or ubuntu is None or has_it(ubuntu, demand):
        return None
    bound = f",<{Version(demand.version or '0').major + 1}"
    return stated(f"cmake>={demand.version}{bound}", "build", demand.file, demand.line)
