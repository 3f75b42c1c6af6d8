"""What is in the tree already, and repositories of one last name in a list: paths and addresses tell them apart."""

from __future__ import annotations

import re
from collections.abc import Collection

from roslab.decide.ros.source_names import address, itself_in, plain
from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Evidence


def twice(git: GitSource, itself: set[str], own: frozenset[str]) -> bool:
    """Tell whether the tree has it, changed perhaps."""
    return itself_in(git, itself) or plain(git.name) in own


def listed_twice(git: GitSource, evidence: Evidence, itself: set[str], own: frozenset[str]) -> bool:
    """Tell whether the tree has what a list names.

    Of several entries that are called like it (``core/base``, ``ros2/base``) that is the one with its address.
    """
    if not twice(git, itself, own):
        return False
    alike = [each for each in evidence.sources if each.kind == "vcs" and each.file == git.file]
    alike = [each for each in alike if plain(each.name) == plain(git.name)]
    names = {plain(name) for name in itself if name not in own}
    here = {address(each.url) for each in alike if plain(address(each.url)) in names}
    return not here or address(git.url) in here


def folder_of(git: GitSource, taken: Collection[str]) -> str:
    """Return the name of its folder in the workspace: the last of a path, all of a list's where another has that."""
    path = git.name.strip("/")
    name = _name(path.rpartition("/")[2])
    return _name(path) if git.kind == "vcs" and name in taken else name


def _name(path: str) -> str:
    return re.sub(r"[^\w.-]+", "_", path).strip(".") or "source"
