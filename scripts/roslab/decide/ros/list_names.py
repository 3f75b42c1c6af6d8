"""The Ubuntu or other system that a list of repositories or a script is for, by its path: ``needs_jammy.repos``."""

from __future__ import annotations

from roslab.evidence.dependency import Dependency, GitSource
from roslab.knowledge.distros import ubuntus
from roslab.knowledge.system_names import other_linuxes, other_systems
from roslab.values.pattern import pattern

_PARTS = pattern(r"[-_./]+")
_RELEASE = pattern(r"ubuntu(\d\d)(?:04)?")


def ubuntus_in(path: str) -> frozenset[str]:
    """Return the codenames of the Ubuntus that a path names: ``deps_jammy.repos``, ``22.04/deps.repos``."""
    lower = path.lower()
    parts = {*_PARTS.split(lower)}
    parts |= {f"{match[1]}04" for part in parts if (match := _RELEASE.fullmatch(part))}  # ubuntu22/
    known = ubuntus().items()
    return frozenset(name for number, name in known if {name, number.replace(".", "")} & parts or number in lower)


def rank(git: GitSource, ubuntu: str | None) -> int:
    """Return 0 for what is of the image's Ubuntu, 2 for what is of another Ubuntu or system, 1 for all others."""
    if named := ubuntus_in(git.file):
        return 0 if ubuntu in named else 2
    parts = {*_PARTS.split(git.file.lower())}
    other = other_systems() & parts or other_linuxes() & {part.rstrip("0123456789") for part in parts}
    return 2 if other else 1


def for_ubuntu(git: GitSource, asked: Dependency, ubuntu: str | None) -> bool:
    """Tell whether a list of the image's Ubuntu has what the build requires: the authors found its package wanting."""
    return git.kind == "vcs" and asked.strength == "declared" and rank(git, ubuntu) == 0
