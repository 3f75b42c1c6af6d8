"""Libraries that were copied whole into a tree, by the names of their folders of headers."""

from __future__ import annotations

import re
from collections.abc import Collection

from roslab.knowledge.copied_libraries import copied_libraries
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_HEADERS = "include"
_PROJECT = pattern(r"^[ \t]*project[ \t]*\([ \t\"]*([\w+-]+)", re.MULTILINE | re.IGNORECASE)


def folders_of_copies(repository: Repository) -> frozenset[str]:
    """Return the names of folders that libraries are known by, but of those that the repository itself is."""
    return repository.once(_folders_of_copies)


def _folders_of_copies(repository: Repository) -> frozenset[str]:
    own = {repository.name.lower(), *_PROJECT.findall(repository.read("CMakeLists.txt").lower())}
    there = {part for folder in repository.folders for part in folder.split("/")}
    found = {each: holds for each, holds in copied_libraries().items() if each in there}
    return frozenset(
        each
        for each, holds in found.items()
        if not any(each.lower() in name for name in own)
        and (not holds or any(f"/{folder}".endswith(f"/{each}/{holds}") for folder in repository.folders))
    )


def in_copy(path: str, folders: Collection[str]) -> bool:
    """Tell whether a file lies in one of these folders, below one for headers: ``include/igl/AABB.h``."""
    parts = path.split("/")[:-1]
    return _HEADERS in parts and any(part in folders for part in parts[parts.index(_HEADERS) :])
