"""A path of the author's machine that a file of the tree names."""

from __future__ import annotations

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class AuthorPath:
    """A path, with the folder of the author's machine that stands for one of the tree, where the tree has the rest."""

    path: str
    file: str
    line: int
    prefix: str = ""
    """The author's folder, ``""`` where nothing of the tree is meant; it may begin with ``~``."""
    folder: str = ""
    """The folder of the tree that it stands for, ``""`` for the root; ``install`` and ``devel`` where ``made``."""
    made: bool = False
    """The build of a workspace writes what is in it."""
    there: bool = True
    """The tree has all of the path, not only the folder that its last part lies in."""
    asked: bool = False
    """The code goes on with it only if it is there."""
