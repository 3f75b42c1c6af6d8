"""Names and addresses of repositories in one spelling, and which needed name asks for which of them."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Set as AbstractSet
from functools import cache

from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.ros.vcs import https
from roslab.knowledge.distros import distros
from roslab.knowledge.released import rosdep_keys
from roslab.knowledge.ros_sources import RosSource
from roslab.values.pattern import pattern

OF_MESSAGES = ("_msgs", "_srvs", "_interfaces")
"""How the names of packages of messages end: https://www.ros.org/reps/rep-0144.html, and in ROS 2
https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Custom-ROS2-Interfaces.html, 2026-11-27"""
SHORTEST = 4
"""Fewest letters of a word that can identify a family of packages."""
_COMMON = frozenset(
    {"msgs", "driver", "drivers", "common", "robot", "core", "tools", "utils", "ros1", "ros2", "catkin", "ament"}
)
_SHORTEST_FIRST = 3
_OF_ALL = frozenset({"ros", "lib", "the", "for", "sim"})
"""Short first words of the names of many families."""
_DEVELOPED = frozenset({"dev", "devel", "develop", "development", "testing", "nightly", "ros1", "ros2"})
_NUMBERED = pattern(r".*\d+[._]\d.*")
"""A ref with the number of a release."""
_PARTS = pattern(r"[-_/]")
_SEPARATORS = pattern(r"[-_.]+")
_TOOLS = frozenset({"catkin", "ament_cmake", "ament_package", "cmake"})


def fixed(ref: str | None) -> str | None:
    """Return a ref that a shell and git can take, else ``None``."""
    return ref if ref and re.fullmatch(r"[\w./+-]+", ref) and not ref.startswith("-") else None


def for_pip(git: GitSource) -> str:
    """Return the line with which pip installs a repository: https://pip.pypa.io/en/stable/topics/vcs-support/."""
    ref = fixed(git.ref)
    return f"git+{https(git.url)}{f'@{ref}' if ref else ''}"


def drifts(ref: str | None) -> bool:
    """Tell whether a ref is a branch by its name, whose commits go on: ``noetic-devel``, ``ros2``, ``feature/humble``.

    Where it is gone, what is taken instead is of its day, too.
    """
    if not ref or _NUMBERED.fullmatch(ref):
        return False
    words = {*_PARTS.split(ref), ref.replace("-", "")}
    return moves(ref) or not words.isdisjoint(_DEVELOPED) or not words.isdisjoint(distros())


def day_of_clone(ref: str | None, day: str) -> str:
    """Return the ``day`` of which a clone is taken, ``""`` for a ref that stays what it is."""
    return "" if ref and not drifts(ref) else day


def moves(ref: str | None) -> bool:
    """Tell whether a ref is the usual name of the newest branch."""
    return ref in {"master", "main"}


def folders(git: GitSource) -> set[str]:
    """Return the names that the folder of a clone, or of its archive, has."""
    return {git.name, git.folder, *([f"{git.name}-{git.ref.removeprefix('v')}"] if git.ref else [])}


@cache
def address(url: str) -> str:
    """Return an address in the one spelling in which two are compared."""
    return https(url).removesuffix(".git").rstrip("/").lower()


@cache
def plain(name: str) -> str:
    """Return a name in the one spelling in which two are compared."""
    return _SEPARATORS.sub("_", name.rpartition("/")[2]).lower()


def telling_words(name: str) -> set[str]:
    """Return the words of a repository's name that can identify a family of packages."""
    return {word for word in plain(name).split("_") if len(word) >= SHORTEST} - _COMMON


def akin(name: str, other: str) -> bool:
    """Tell whether two names share a telling word, or begin with the same one: ``mav_msgs`` and ``mav_comm``."""
    first = plain(name).partition("_")[0]
    begins = (
        len(first) >= _SHORTEST_FIRST and first not in _COMMON | _OF_ALL and first == plain(other).partition("_")[0]
    )
    return begins or bool(telling_words(name) & telling_words(other))


def wraps(name: str) -> bool:
    """Tell whether a package wraps a library for catkin, which it fetches and compiles: ``yaml_cpp_catkin``."""
    return name.endswith("_catkin")


def itself_in(git: GitSource, names: set[str]) -> bool:
    """Tell whether a list or a page names the repository itself, ``c-blox`` where it is ``cblox`` by now.

    So does a clone of any name into a folder of the repository's or its package's name: it may have been renamed.
    """
    if git.into.lower() in names:
        return True
    joined = {plain(name).replace("_", "") for name in names}
    return plain(git.name).replace("_", "") in joined or address(git.url).rpartition("/")[2] in names


def wanted_names(needed: Iterable[Dependency]) -> dict[str, Dependency]:
    """Return the needed names in one spelling, without build tools, which the base image has."""
    found: dict[str, Dependency] = {}
    for dependency in needed:
        if dependency.role == "buildtool" and dependency.name in _TOOLS:
            continue
        if dependency.role == "exec" and dependency.strength == "optional":
            continue  # a launch file starts it under a condition only
        found.setdefault(plain(dependency.name), dependency)
        if dependency.name.startswith("lib"):
            found.setdefault(plain(dependency.name[3:]), dependency)
    return found


def stands_already(git: GitSource, known: AbstractSet[str], cloned: AbstractSet[str]) -> bool:
    """Tell whether a repository is there in another form: itself, under another name, or one that is cloned instead."""
    return git.into in known or (git.kind == "link" and plain(git.name) in cloned)


def called_like(git: GitSource, asked: Dependency) -> bool:
    """Tell whether a clone is called what asks for it: ``stonefish`` for ``Stonefish``, ``g2o`` for ``libg2o``."""
    return plain(asked.name).removeprefix("lib") in {plain(git.name).removeprefix("lib"), plain(git.folder)}


def asked_for(git: GitSource, wanted: dict[str, Dependency], known: frozenset[str]) -> Dependency | None:
    """Return what needs a clone: a name equal to the clone's, or an unreleased package whose name begins with it.

    A key that rosdep does not have also matches a clone with the key's first word in its name: ``vikit_ros`` matches
    ``rpg_vikit``.
    """
    for name in (plain(git.name), plain(git.folder)):
        if name in wanted:
            return wanted[name]
    name = plain(git.name)
    unknown = [(each, d) for each, d in wanted.items() if d.name not in known]
    family = (d for each, d in unknown if each.startswith(f"{name}_") and d.namespace in {"rosdep", "ros"})
    words = telling_words(name)
    related = (d for each, d in unknown if d.namespace == "rosdep" and each.partition("_")[0] in words)
    return next(family, None) or next((d for d in related if d.name not in rosdep_keys()), None)


def as_clone(found: RosSource, asked: Dependency) -> GitSource:
    """Return the repository of a row of the table of unreleased packages, called as where a page clones it."""
    return GitSource(
        name=found.repo.rpartition("/")[2].removesuffix(".git"),
        url=found.repo,
        ref=found.ref,
        strength=asked.strength,
        file=asked.file,
        line=asked.line,
        kind="clone",
    )
