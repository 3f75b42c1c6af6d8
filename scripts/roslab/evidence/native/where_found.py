"""Includes that are compiled only where CMake found the library that they are of: ``#if XTENSOR_FOUND``."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterator
from functools import lru_cache
from itertools import islice

from roslab.values.pattern import pattern

_DIRECTIVE = pattern(r"^[ \t]*#[ \t]*(if|ifdef|ifndef|elif|else|endif)\b([^\n]*)", re.MULTILINE)
_NUMBER = pattern(r"\d+$")
_NEGATED = pattern(r"!\s{0,9}(?:defined\b)?[\s(]{0,9}$")
_BEFORE = ("HAVE_", "WITH_", "USE_", "HAS_")
_AFTER = "_FOUND"
LONGEST = 400
"""Most characters of a condition that are read."""
NEAREST = 40
"""Most characters before a name in which it is negated."""
DEEPEST = 30
"""Most conditions around a line that are looked at, the innermost first."""


class _Open:
    """A condition that a line stands under, ``""`` where it asks for nothing, and that around it."""

    __slots__ = ("around", "condition")

    def __init__(self, condition: str, around: _Open | None) -> None:
        self.condition, self.around = condition, around


def where_found(text: str, position: int, header: str) -> bool:
    """Tell whether a header at a position of a file stands under a condition that its library is there, or is used.

    The name of the library is that of the header's folder, or of the header itself where it has none.
    """
    places, conditions = _conditions(text)
    number = bisect_left(places, position)
    if not number:
        return False
    name = header.partition("/")[0].partition(".")[0].upper().replace("-", "_")
    names = {name, _NUMBER.sub("", name)}
    asked = {f"{prefix}{each}" for each in names for prefix in _BEFORE} | {f"{each}{_AFTER}" for each in names}
    return any(_asks(each, asked) for each in islice(_around(conditions[number - 1]), DEEPEST))


def _around(condition: _Open | None) -> Iterator[str]:
    while condition:
        yield condition.condition
        condition = condition.around


@lru_cache(maxsize=2)
def _conditions(text: str) -> tuple[list[int], list[_Open | None]]:
    """Return where the conditions of a file begin, change and end, and which one is open from there on.

    They are read once for all headers of the file, and not where it asks for no library at all.
    """
    places: list[int] = []
    found: list[_Open | None] = []
    upper = text.upper()
    if not any(each in upper for each in (*_BEFORE, _AFTER)):
        return places, found
    now: _Open | None = None
    for match in _DIRECTIVE.finditer(text):
        kind, condition = match[1], match[2][:LONGEST]
        if kind == "endif":
            now = now.around if now else None
        elif kind.startswith("if"):
            now = _Open("" if kind == "ifndef" else condition, now)
        elif now:
            now = _Open(condition if kind == "elif" else "", now.around)
        places.append(match.start())
        found.append(now)
    return places, found


def _asks(condition: str, names: set[str]) -> bool:
    """Tell whether a condition asks for one of the names, and not for that it is not there."""
    for word in re.finditer(r"\w+", condition):
        before = condition[max(0, word.start() - NEAREST) : word.start()]
        if word[0].upper() in names and not _NEGATED.search(before):
            return True
    return False
