"""The folders that a page makes before a command, in which the program writes."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable

from roslab.evidence.facts import Mention


def made_before(command: Mention, made: Iterable[Mention]) -> tuple[str, ...]:
    """Return the folders that a page makes right before a command, by their paths from where it is.

    Not one to build in; what a page makes before it goes to another folder is not read.
    """
    there = (m for m in made if (m.file, m.heading) == (command.file, command.heading))
    near = (posixpath.normpath(m.value) for m in there if 0 <= command.line - m.line <= 1)
    return tuple(path for path in near if not path.startswith("build"))
