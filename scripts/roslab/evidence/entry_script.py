"""A script of the tree that an author's ENTRYPOINT names."""

from __future__ import annotations

from typing import Literal

from roslab.values.dataclass import dataclass

Taken = Literal["commands", "arguments", "nothing"]
"""What an entry point does with the words behind the image's name: it starts them as a command, hands them to its own
program, or never looks at them."""


@dataclass(frozen=True, kw_only=True, slots=True)
class EntryScript:
    """What such a script does with the words that it is given, and what it needs."""

    file: str
    line: int
    """The line of its last command."""
    takes: Taken
    shell: bool = False
    """It ends with a shell, and starts no program before."""
    alone: bool = False
    """It starts what it is given, and a program where it is given nothing."""
    unset: tuple[tuple[str, int], ...] = ()
    """Variables that it reads without a default, and neither it nor the Dockerfile sets; each with its line."""
    absent: tuple[tuple[str, str, int], ...] = ()
    """Folders that it changes to, each with the part of its path that nothing makes, and its line."""
    stops: bool = False
    """It stops at a command that fails (``set -e``)."""
