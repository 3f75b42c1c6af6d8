"""From the names that readers found to the apt packages of one image."""

from __future__ import annotations

from roslab.evidence.dependency import Dependency
from roslab.evidence.native.cmake_needs import COMPONENT
from roslab.evidence.native.searched import SEARCHED
from roslab.knowledge.apt_sources import folder_of_package
from roslab.knowledge.code_limits import satisfies
from roslab.knowledge.distros import distro, ever, python_of_ubuntu
from roslab.knowledge.libraries import Library, header, library
from roslab.knowledge.released import released
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass, replace
from roslab.values.pattern import pattern

MOST_OF_A_PATTERN = 30
"""Most packages that are taken for one pattern of names: more hold drivers and tools that nobody meant."""
APT_NAME = pattern(r"^[a-z0-9][a-z0-9.+-]+$")
ANY_PYTHON = "-py3*-"
"""In a name of apt, for the Python of whichever Ubuntu: ``robotpkg-py3*-pinocchio``."""
_OF_PYTHON = pattern(r"-py3\d{1,2}-")
_PLACEHOLDER = pattern(r"^ros-(\{distro\}|[a-z]+)-(.+)$")


@dataclass(frozen=True, kw_only=True, slots=True)
class Target:
    """The image that packages are for."""

    ros_distro: str | None
    ubuntu: str | None
    cuda: bool = False
    """The base has CUDA's compiler."""
    modules: frozenset[str] = frozenset()
    """What files of the tree find for CMake: it then needs no configuration file of a library."""
    unfound: frozenset[str] = frozenset()
    """Packages of which the code would not find ROS's."""

    def ros(self, name: str) -> str:
        """Return the apt name of a ROS package."""
        return f"ros-{self.ros_distro}-{name.replace('_', '-').lower()}"

    def knows(self, name: str) -> bool:
        """Tell whether the image's ROS released a package of that name."""
        return bool(self.ros_distro) and name in released(self.ros_distro or "")

    def released_as(self, name: str) -> str | None:
        """Return the package that the image's ROS released for a name of CMake, which may have capitals or dashes."""
        return next((each for each in spellings(name) if self.knows(each)), None)


def spellings(name: str) -> tuple[str, ...]:
    """Return how a package of ROS may be called whose configuration file for CMake has a name: ``Fields2Cover``."""
    small = name.lower()
    return (name, *dict.fromkeys((small, small.replace("-", "_"), small.replace("_", "-"))))


@dataclass(frozen=True, kw_only=True, slots=True)
class Resolved:
    """The packages that one name stands for."""

    apt: tuple[str, ...] = ()
    beside: tuple[str, ...] = ()
    """Packages that are only guessed, even if the name itself is certain."""
    recipe: str = ""
    known: bool = True
    """False for a name that no table has, and for one that only another ROS or Ubuntu has."""


def resolve(dependency: Dependency, target: Target) -> Resolved:
    """Return the apt packages of a name in its own namespace."""
    if dependency.namespace == "apt":
        return Resolved(apt=_apt(dependency.name, target))
    if dependency.namespace == "ros":
        return _ros(dependency.name, target)
    if dependency.namespace == "include":
        return _include(dependency.name, target)
    if dependency.namespace in {"cmake", "pkg-config", "link"}:
        found = library(dependency.namespace, dependency.name, target.ubuntu)
        if found is None and dependency.role == SEARCHED:
            found = library("cmake", dependency.name, target.ubuntu)
        if found is not None:
            found = _of_release(found, dependency, target)
            own = dependency.namespace == "cmake" and dependency.role != COMPONENT and dependency.name in target.modules
            resolved = _library((own and _by_link(found, dependency.name, target)) or found, target)
            if resolved.known or not found.elsewhere or dependency.namespace == "link" or own:
                return resolved
        if dependency.namespace != "link":
            other = None if dependency.name in target.modules else target.released_as(dependency.name)
            return _ros(other or dependency.name, target)
    return Resolved(known=False)


def _of_release(found: Library, asked: Dependency, target: Target) -> Library:
    """Return where a library comes from: not from ROS where CMake asks for a release that Ubuntu alone has."""
    if not (found.ros and found.apt and asked.namespace == "cmake" and asked.version and target.ubuntu):
        return found
    of_ros, of_ubuntu = (satisfies(asked.name, target.ubuntu, asked.version, ros=ros) for ros in (True, False))
    return replace(found, ros="") if of_ubuntu and not of_ros else found


def _by_link(found: Library, name: str, target: Target) -> Library | None:
    """Return the package of a library that is compiled for its configuration file alone, where there is one."""
    linked = library("link", name.lower(), target.ubuntu) if found.recipe and not found.apt else None
    return linked if linked and linked.apt else None


def _library(found: Library, target: Target) -> Resolved:
    """Prefer a ROS package of the image's distribution: its other packages were built with it.

    Not one that the code does not find there, where it finds Ubuntu's.
    """
    if (
        found.ros
        and target.knows(found.ros)
        and not (found.ros in target.unfound and _in_default_folders(found, target))
    ):
        return Resolved(apt=(target.ros(found.ros),), beside=found.beside)
    known = bool(found.apt or found.recipe or not (found.ros or found.elsewhere))
    return Resolved(apt=found.apt, beside=found.beside, recipe=found.recipe if not found.apt else "", known=known)


def _in_default_folders(found: Library, target: Target) -> bool:
    """Tell whether Ubuntu's package of a library has its files where every compiler looks."""
    row = next((row for row in rows("found_by_variables") if row["package"] == found.ros), None)
    return bool(found.apt and row and target.ubuntu in row["ubuntus"].split())


def _ros(name: str, target: Target) -> Resolved:
    if target.knows(name):
        return Resolved(apt=(target.ros(name),))
    found = library("cmake", name, target.ubuntu)
    return _library(found, target) if found else Resolved(known=False)


def _include(path: str, target: Target) -> Resolved:
    found = header(path, target.ubuntu)
    resolved = _library(found, target) if found is not None else Resolved(known=False)
    if found is not None and (resolved.known or not found.elsewhere):
        return resolved
    name = path.partition("/")[0]
    if "/" in path and target.knows(name):
        return Resolved(apt=(target.ros(name),))
    return resolved


def _apt(name: str, target: Target) -> tuple[str, ...]:
    """Put the image's distribution into an apt name from prose, whichever one it was written for."""
    match = _PLACEHOLDER.match(name)
    if match and written_for(name):
        if not target.ros_distro:
            return ()
        if match[2].endswith("*"):
            return _beginning(match[2].rstrip("*"), target)
        if _of_the_other_ros(match[1], target) and not target.knows(match[2].replace("-", "_")):
            return ()
        name = f"ros-{target.ros_distro}-{match[2]}"
    python = python_of_ubuntu().get(target.ubuntu or "", "")
    if ANY_PYTHON in name:
        name = name.replace(ANY_PYTHON, f"-py{python.replace('.', '') or '*'}-")
    elif python and _OF_PYTHON.search(name) and folder_of_package(name):  # of the author's Ubuntu, which may be another
        name = _OF_PYTHON.sub(f"-py{python.replace('.', '')}-", name, count=1)
    return (name,) if APT_NAME.match(name) else ()


def _of_the_other_ros(name: str, target: Target) -> bool:
    """Tell whether a distribution is one of ROS 1 and the image's of ROS 2, or the other way round."""
    written, here = distro(name), distro(target.ros_distro or "")
    return written is not None and here is not None and written.ros != here.ros


def _beginning(start: str, target: Target) -> tuple[str, ...]:
    """Return the released packages whose names begin so, as apt reads ``ros-noetic-navigation*``.

    Of too many, it is the one of that name alone. https://manpages.ubuntu.com/manpages/focal/man8/apt-get.8.html
    """
    begins = target.ros(start)
    names = (target.ros(name) for name in released(target.ros_distro or ""))
    found = tuple(sorted(name for name in names if name.startswith(begins)))
    return found if len(found) <= MOST_OF_A_PATTERN else tuple(n for n in found if n == target.ros(start.rstrip("-")))


def written_for(name: str) -> str | None:
    """Return the distribution in an apt name, ``{distro}`` for a placeholder, ``None`` for ``ros-dev-tools``."""
    match = _PLACEHOLDER.match(name)
    return match[1] if match and (match[1] in ever() or match[1] == "{distro}") else None
