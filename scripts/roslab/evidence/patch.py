"""A patch of the tree that its author applies to something cloned."""

from __future__ import annotations

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Patch:
    """A patch, and the command that applies it."""

    path: str
    """Of its file, from the root."""
    folder: str
    """Where it is applied: the end of a path, in which a clone's folder may stand; ``""`` where it is not known."""
    command: tuple[str, ...]
    """``git apply`` or ``patch`` with its options, without the file."""
    stops: bool
    """The author's build stops where it fails."""
    touches: tuple[str, ...]
    """The files that it changes, as it names them."""
    file: str
    line: int
