"""One stage of an author's Dockerfile: where it is, what it holds, and what a container of it starts with."""

from __future__ import annotations

import posixpath

from roslab.values.dataclass import dataclass


@dataclass
class Start:
    """What a container of a stage starts with; a stage that is made from another one begins with its values."""

    entrypoint: tuple[str, ...] = ()
    command: tuple[str, ...] = ()
    line: int | None = None
    workdir: str = "/"
    source: str | None = None
    """The folder that the whole context is copied to."""
    kept: tuple[str, ...] | None = ()
    """What it has of the tree, as far as that comes from other stages; ``None`` where it may be all."""
    environment: tuple[tuple[str, str, int], ...] = ()
    """Its variables, each with its value and the line that sets it."""


def from_start(start: Start) -> str:
    """Return the path to the copy of the build context from where a container starts, if both are known."""
    if start.source is None or "$" in f"{start.source}{start.workdir}":
        return ""
    return posixpath.relpath(start.source, posixpath.join("/", start.workdir))
