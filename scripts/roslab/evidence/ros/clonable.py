"""Which repositories of others an image can clone to their places in the tree."""

from __future__ import annotations

from roslab.evidence.dependency import GitSource
from roslab.values.pattern import pattern

ADDRESS = pattern(r"https?://")
"""An image has no key for ssh, and no path of somebody's machine."""
PATH = pattern(r"(?!\.\.?(?:/|$))[\w.+-]+(?:/(?!\.\.?(?:/|$))[\w.+-]+)*")
"""One that leads out of the tree is none."""
_BESIDE = "../"
"""Where a page clones something that CMake takes from beside the tree."""


def can_be_cloned(git: GitSource) -> bool:
    """Tell whether its address, by https where a host serves it so, and its path are such."""
    path = git.name.removeprefix(_BESIDE) if git.kind == "inside" else git.name
    return bool(ADDRESS.match(git.url) and PATH.fullmatch(path))
