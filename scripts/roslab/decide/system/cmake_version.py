"""Which CMake version the build asks for, and whether the Ubuntu has it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.config.model import Kind
from roslab.decide.ros.source_names import address, plain
from roslab.decide.ros.workspace import packages_of
from roslab.decide.system.added_projects import added_by
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.python_project import PythonProject
from roslab.knowledge.distros import cmake_of_ubuntu
from roslab.knowledge.ros_sources import RosSource, ros_sources
from roslab.values.dataclass import replace
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version

NEW = Version("4.0")
"""The first CMake that refuses code which asks for one before ``KEPT_BY_NEW``, but for what a variable tells it."""
KEPT_BY_NEW = Version("3.5")
POLICY = "CMAKE_POLICY_VERSION_MINIMUM"
"""https://cmake.org/cmake/help/latest/envvar/CMAKE_POLICY_VERSION_MINIMUM.html; an older CMake does not read it."""
BRINGS_CMAKE = frozenset({"cmake", "scikit-build-core"})
"""What builds Python packages and has CMake, or asks pip for it."""


def needed_cmake(evidence: Evidence) -> Dependency | None:
    """Return the highest version that any CMakeLists.txt of the build requires, with the line that requires it.

    One that calls what only later releases have requires those, whatever it says. So does each file that these add.
    """
    folders = {manifest.file.rpartition("/")[0] for manifest in packages_of(evidence).built}
    projects = [project for project in evidence.cmake if not places.aside(project.file)]
    built = [p for p in projects if (p.file.rpartition("/")[0] in folders or (not folders and p.top_level))]
    built.sort(key=lambda project: project.file.count("/"))
    parts = {
        p.file: p for p in (*built, *_below(built, projects), *added_by(built, evidence.cmake, usual=True).projects)
    }
    return highest(built, parts.values())


def highest(built: Iterable[CMakeProject], parts: Iterable[CMakeProject]) -> Dependency | None:
    """Return the highest version that projects require, with the files that they add."""
    demands = [project.minimum for project in built if project.minimum]
    demands += [each for project in parts for each in project.newer]
    return max(demands, key=lambda demand: Version(demand.version or "0"), default=None)


def _below(built: Iterable[CMakeProject], projects: Iterable[CMakeProject]) -> list[CMakeProject]:
    """Return what lies in folders of the projects that are built and is no project by itself."""
    above = tuple(f"{project.file.rpartition('/')[0]}/".lstrip("/") for project in built)
    return [p for p in projects if p.name is None and not p.top_level and p.file.startswith(above)]


def has_it(ubuntu: str, demand: Dependency | None) -> bool:
    """Tell whether an Ubuntu's own CMake is new enough."""
    return demand is None or Version(cmake_of_ubuntu()[ubuntu]) >= Version(demand.version or "0")


def from_pip(
    evidence: Evidence,
    kind: Kind,
    ubuntu: str | None,
    projects: Iterable[PythonProject],
    ros_distro: str | None,
) -> Requirement | None:
    """Return CMake as a pip requirement if the Ubuntu's is too old, below the next major version.

    CMake 4 refuses projects that ask for a version before 3.5, and a dependency of the repository may be one of them.
    Beside ``projects``, those that pip installs, CMake compiles code of CUDA only where one of them is its too.
    """
    tops = {project.file.rpartition("/")[0] for project in evidence.cmake if project.top_level}
    aside = kind == "cuda" and bool(own := {each.folder for each in projects}) and own.isdisjoint(tops)
    demands = () if kind == "python" or aside else (needed_cmake(evidence), *_of_sources(evidence, kind, ros_distro))
    demand = max(filter(None, demands), key=lambda each: Version(each.version or "0"), default=None)
    if demand is None or ubuntu is None or has_it(ubuntu, demand):
        return None
    bound = f",<{Version(demand.version or '0').major + 1}"
    return stated(f"cmake>={demand.version}{bound}", "build", demand.file, demand.line)


def _of_sources(evidence: Evidence, kind: Kind, ros_distro: str | None) -> Iterator[Dependency]:
    """Yield what packages need of repositories that the table clones and that ask for a CMake, with its version."""
    packages = packages_of(evidence)
    asked = (each for manifest in packages.built for each in manifest.dependencies if each.name not in packages.names)
    for each in asked if kind in {"ros1", "ros2"} else ():
        for found in ros_sources(each.name, 1 if kind == "ros1" else 2, ros_distro or ""):
            if found.cmake and not _cloned_elsewhere(found, evidence):
                yield replace(each, version=found.cmake)


def _cloned_elsewhere(found: RosSource, evidence: Evidence) -> bool:
    """Tell whether a page or a list has another repository of the name, which is cloned in place of the table's."""
    named = (git for git in evidence.sources if git.kind != "link" and plain(git.name) == found.package)
    return any(address(git.url) != address(found.repo) for git in named)


def refused_by_new(evidence: Evidence, ubuntu: str | None, asked: Iterable[Requirement]) -> Dependency | None:
    """Return the oldest version that a file of CMake names, where a CMake of the image may refuse it.

    ``asked``: what pip installs or builds with; a CMake or a backend without an upper bound is the newest there is.
    Copied code counts: it is configured with the rest, and so are templates. https://cmake.org/cmake/help/latest/release/4.0.html
    """
    demands = [project.minimum for project in evidence.cmake if project.minimum and not places.sample(project.file)]
    demands += [_of_template(mention) for mention in evidence.mentions if mention.topic == "template"]
    oldest = min(demands, key=lambda demand: Version(demand.version or "0"), default=None)
    if oldest is None or Version(oldest.version or "0") >= KEPT_BY_NEW:
        return None
    ours = Version(cmake_of_ubuntu().get(ubuntu or "", "0"))
    fetched = [each for each in asked if each.key in BRINGS_CMAKE and each.specifier.contains(str(NEW))]
    in_conda = any(p.name == "cmake" and not p.version for conda in evidence.conda for p in conda.packages)
    return oldest if ours >= NEW or fetched or in_conda else None


def _of_template(mention: Mention) -> Dependency:
    return Dependency(
        namespace="cmake",
        name="CMake",
        strength="declared",
        file=mention.file,
        line=mention.line,
        role="build",
        version=mention.value,
    )
