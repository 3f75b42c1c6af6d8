"""Hints, which tell that a pattern need not be tried on a text: every match of it holds one of them.

The tables have some dozens for Python code. To find out which words a module has takes as long as to look for fifteen
of them, one after the other; the rows that can match are then found by these words.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from typing import Generic, Protocol, TypeVar

from roslab.knowledge.standard_modules import of_python_2
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

_TABLES = ("code_limits", "companions", "program_calls", "removals", "window_calls")
_ALSO = frozenset(
    (
        *("__main__", "popen", "print", "require_version", "subprocess", "system"),
        *("ALE", "AtariPreprocessing", "Repo", "atari_wrappers", "install", "ram", "render", "render_mode"),
    )
)
"""What readers look for that have no table."""
_SHORT = 3
"""Most letters of a part that a pattern finds in half the time that ``in`` takes."""
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


class Hinted(Protocol):
    """A row of a table that has hints."""

    @property
    def hints(self) -> Hints:
        """Those of its pattern."""


Row = TypeVar("Row", bound=Hinted)


class Search(Generic[Row]):
    """Rows that are looked for in one text after the other: of each, only those that can match are tried."""

    def __init__(self, rows: Iterable[Row], *, words: bool = False) -> None:
        """With ``words``, hints that are names are looked for among the words of the texts, not in these."""
        self._rows = tuple(rows)
        self._words = words
        self._by_word: dict[str, list[int]] = {}
        self._by_part: dict[str, list[int]] = {}
        for number, row in enumerate(self._rows):
            for hint in row.hints.each:
                by = self._by_word if words and hint in row.hints.words else self._by_part
                by.setdefault(hint, []).append(number)
        by_letter: dict[str, list[str]] = {}
        for part in self._by_part:
            by_letter.setdefault(part[:1], []).append(part)
        groups = (parts for parts in by_letter.values() if len(parts) > 1 or len(parts[0]) <= _SHORT)
        self._by_pattern = [(_any_of(parts), [(part, self._by_part.pop(part)) for part in parts]) for parts in groups]
        """Parts that begin with the same letter, which a pattern looks for once for all of them."""

    def possible(self, text: str, words: frozenset[str] = frozenset()) -> list[Row]:
        """Return the rows of which a hint stands in a text, or among its words, in their order."""
        found = {number for word in words for number in self._by_word.get(word, ())}
        for part, numbers in self._by_part.items():
            if not (found and found.issuperset(numbers)) and part in text:
                found.update(numbers)
        for each, parts in self._by_pattern:
            if each.search(text):
                found.update(number for part, numbers in parts if part in text for number in numbers)
        return [self._rows[number] for number in sorted(found)]

    def without(self, row: Row) -> Search[Row]:
        """Return the search for the other rows."""
        return Search((other for other in self._rows if other is not row), words=self._words)


def _any_of(parts: list[str]) -> re.Pattern[str]:
    """Return a pattern for any of the parts, all of which begin with the same letter."""
    return pattern(f"{re.escape(parts[0][:1])}(?:{'|'.join(re.escape(part[1:]) for part in parts)})")


def hints(cell: str) -> Hints:
    """Return the hints that a cell of a table holds."""
    each = tuple(cell.split("|"))
    words = frozenset(filter(str.isidentifier, each))
    return Hints(each=each, words=words, parts=tuple(hint for hint in each if hint not in words))


def words_of(text: str) -> frozenset[str]:
    """Return the names in a text that are hints."""
    words = text.encode(errors="replace").translate(_BLANK).split()
    return frozenset(word.decode() for word in _names().intersection(words))


@cache
def _names() -> frozenset[bytes]:
    cells = (row["hints"] for table in _TABLES for row in rows(table))
    return frozenset(word.encode() for word in _ALSO.union(of_python_2(), *(hints(cell).words for cell in cells)))
