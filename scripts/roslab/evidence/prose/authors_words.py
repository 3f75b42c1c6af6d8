"""Paths of the author's machine in a command of a page, where the tree has what one of them means."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_PATH = pattern(r"/(?!(?:usr|etc|opt|dev|proc|sys|tmp)/)(?:[\w.+@~-]+/)+[\w.+@=~-]+")
"""A path from the root of a machine, but for those that every machine has."""
_SHORTEST = 2
"""Fewest last parts of a path by which the tree's file is known."""


def of_author(words: Sequence[str], repository: Repository) -> list[str]:
    """Return a command of Python's with each path that begins with the author's copy of the tree, from the root.

    ``/data/me/code/cfg/a.yaml`` is ``cfg/a.yaml`` of the tree; so ``/data/me/code`` is the tree, and what the command
    writes below it goes there.
    """
    if not words or not words[0].startswith("python"):
        return [*words]
    whole = (word.rpartition("=")[2] for word in words[1:])
    prefix = next(filter(None, (_prefix(word, repository) for word in whole)), "")
    return [_below(word, prefix) for word in words] if prefix else [*words]


def _prefix(path: str, repository: Repository) -> str:
    """Return the folder of the author's that stands for the root, with a slash, ``""`` if no file tells."""
    parts = path.split("/") if _PATH.fullmatch(path) else []
    for start in range(2, len(parts) - _SHORTEST + 1):
        rest = "/".join(parts[start:])
        if repository.has(rest):
            return path.removesuffix(rest)
    return ""


def _below(word: str, prefix: str) -> str:
    option, sign, path = word.rpartition("=")
    if path.rstrip("/") == prefix.rstrip("/"):
        return f"{option}{sign}."
    return f"{option}{sign}{path.removeprefix(prefix)}" if path.startswith(prefix) else word
