"""What files of a tree are beside a build: not read by it, made by another one, or written by it."""

from __future__ import annotations

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class WorkspaceFiles:
    """Files and folders, relative to the root."""

    unread: tuple[str, ...] = ()
    """Names at the top that no build reads."""
    made_elsewhere: tuple[str, ...] = ()
    """What a build on another machine left."""
    written_beside: bool = False
    """Whether CMake writes to the source or to the user's home while it compiles."""
