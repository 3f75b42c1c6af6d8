"""The Ubuntu or other system that a list of repositories is for, by its name: ``dependencies_jammy.repos``."""

from __future__ import annotations

from roslab.evidence.dependency import Dependency, GitSource
from roslab.knowledge.distros import ubuntus
from roslab.values.pattern import pattern

_PARTS = pattern(r"[-_./]+")
OTHER_SYSTEMS = ("windows", "win", "win32", "win64", "mac", "macos", "osx", "darwin", "android")


def ubuntus_in(path: str) -> frozenset[str]:
    """Return the codenames of the Ubuntus that a path names: ``deps_jammy.repos``, ``22.04/deps.repos``."""
    lower = path.lower()
    parts = {*_PARTS.split(lower)}
    known = ubuntus().items()
    return frozenset(name for number, name in known if {name, number.replace(".", "")} & parts or number in lower)


def rank(git: GitSource, ubuntu: str | None) -> int:
    """Return 0 for a list of the image's Ubuntu, 2 for one of another Ubuntu or system, 1 for all others."""
    if git.kind != "vcs":
        return 1
    if named := ubuntus_in(git.file):
        return 0 if ubuntu in named else 2
    return 1 if {*_PARTS.split(git.file.lower())}.isdisjoint(OTHER_SYSTEMS) else 2


def for_ubuntu(git: GitSource, asked: Dependency, ubuntu: str | None) -> bool:
    """Tell whether a list of the image's Ubuntu has what the build requires: the authors found its package wanting."""
    return asked.strength == "declared" and rank(git, ubuntu) == 0
