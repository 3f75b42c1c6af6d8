"""Modules that the default command's files import at their top, of the packages that are only tried."""

from __future__ import annotations

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class CommandImports:
    """The command does not start without one of them."""

    required: tuple[str, ...] = ()
    """What its own file imports and lines of the README install: an image without it gets no tag."""
    tried: tuple[str, ...] = ()
    """What it or modules of the tree import and a guess may bring: what is not there is told."""


NO_IMPORTS = CommandImports()
