"""Hints, which tell that a pattern need not be tried on a text: every match of it holds one of them.

The tables have some dozens for Python code. To find out which words a module has takes as long as to look for fifteen
of them, one after the other.
"""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass

_TABLES = ("code_limits", "removals", "window_calls")
_ALSO = frozenset({"__main__", "print", "require_version"})
"""What readers look for that have no table."""
_BLANK = bytes(byte if chr(byte).isascii() and (chr(byte).isalnum() or byte == ord("_")) else 32 for byte in range(256))
"""What stands for each byte of a text that is to be split into words."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Hints:
    """The hints of one pattern, parted by ``|`` in a table."""

    each: tuple[str, ...]
    words: frozenset[str]
    """Those that are a name: it stands in every match as a whole word."""
    parts: tuple[str, ...]
    """The others, which may stand anywhere."""

    def stand_in(self, text: str) -> bool:
        """Tell whether one of them stands in a Python module."""
        return not self.words.isdisjoint(words_of(text)) or any(part in text for part in self.parts)

    def are_part_of(self, text: str) -> bool:
        """Tell whether one of them stands anywhere in a text, which is faster where few ask about it."""
        return any(hint in text for hint in self.each)


def hints(cell: str) -> Hints:
    """Return the hints that a cell of a table holds."""
    each = tuple(cell.split("|"))
    words = frozenset(filter(str.isidentifier, each))
    return Hints(each=each, words=words, parts=tuple(hint for hint in each if hint not in words))


@cache
def words_of(text: str) -> frozenset[str]:
    """Return the names in a text that are hints: several readers ask about each module."""
    words = text.encode("ascii", errors="replace").translate(_BLANK).split()
    return frozenset(word.decode() for word in _names().intersection(words))


@cache
def _names() -> frozenset[bytes]:
    cells = (row["hints"] for table in _TABLES for row in rows(table))
    return frozenset(word.encode() for word in _ALSO.union(*(hints(cell).words for cell in cells)))
