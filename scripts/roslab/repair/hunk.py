"""The one place at which two texts differ: what a suggestion in a pull request can replace."""

from __future__ import annotations

import difflib

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Hunk:
    """Lines ``start`` to ``end`` of a file, from 1, and the lines to put in their place."""

    file: str
    start: int
    end: int
    new: tuple[str, ...]


def hunk(file: str, old: str, new: str) -> Hunk | None:
    """Return the only difference of two texts, ``None`` if there are several or none.

    An insertion replaces the line above it by itself and the new lines, because a suggestion needs a line to replace.
    """
    before, after = old.splitlines(), new.splitlines()
    changes = [c for c in difflib.SequenceMatcher(a=before, b=after, autojunk=False).get_opcodes() if c[0] != "equal"]
    if len(changes) != 1 or not before:
        return None
    _, start, end, first, last = changes[0]
    if start == end:  # an insertion
        if start == 0:
            return Hunk(file=file, start=1, end=1, new=(*after[first:last], before[0]))
        return Hunk(file=file, start=start, end=start, new=(before[start - 1], *after[first:last]))
    return Hunk(file=file, start=start + 1, end=end, new=tuple(after[first:last]))
