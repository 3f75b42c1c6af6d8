"""For which system the name of a list of repositories says that it is: ``dependencies_jammy.repos``."""

from __future__ import annotations

from roslab.evidence.dependency import Dependency, GitSource
from roslab.knowledge.distros import ubuntus
from roslab.values.pattern import pattern

_PARTS = pattern(r"[-_./]+")
_OTHERS = frozenset(("windows", "win", "win32", "win64", "mac", "macos", "osx", "darwin", "android"))


def rank(git: GitSource, ubuntu: str | None) -> int:
    """Return 0 for a list of the image's Ubuntu, 2 for one of another Ubuntu or system, 1 for all others."""
    if git.kind != "vcs":
        return 1
    parts = {*_PARTS.split(git.file.lower())}
    named = {codename for version, codename in ubuntus().items() if {codename, version.replace(".", "")} & parts}
    if named:
        return 0 if ubuntu in named else 2
    return 2 if parts & _OTHERS else 1


def for_ubuntu(git: GitSource, asked: Dependency, ubuntu: str | None) -> bool:
    """Tell whether a list of the image's Ubuntu has what the build requires: the authors found its package wanting."""
    return asked.strength == "declared" and rank(git, ubuntu) == 0
