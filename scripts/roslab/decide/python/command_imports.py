"""Modules that the default command's files import at their top, and those that no code needs."""

from __future__ import annotations

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class CommandImports:
    """The command does not start without one of them."""

    required: tuple[str, ...] = ()
    """What its own file imports and lines of the README install: an image without it gets no tag."""
    tried: tuple[str, ...] = ()
    """What it or modules of the tree import and a guess may bring: what is not there is told."""
    caught: tuple[str, ...] = ()
    """Modules without which the code goes on, wherever it imports them: of a declared package, too."""


NO_IMPORTS = CommandImports()
