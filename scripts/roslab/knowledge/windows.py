"""Libraries that open windows, and calls that do."""

from __future__ import annotations

import re
from functools import cache
from typing import Literal

from roslab.knowledge.hints import Hints, Search, hints
from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern


@cache
def _patterns() -> dict[str, tuple[re.Pattern[str], ...]]:
    kinds = dict.fromkeys(row["where"] for row in rows("windows"))
    return {kind: tuple(pattern(row["pattern"]) for row in rows("windows") if row["where"] == kind) for kind in kinds}


@cache
def opens(where: str, name: str) -> bool:
    """Tell whether a library opens windows, by its name for ``find_package``, its header or its Python module."""
    return any(each.search(name) for each in _patterns().get(where, ()))


@cache
def shown_with() -> dict[str, str]:
    """Return by library of Python what pip installs so that it opens windows: it does not ask for it itself."""
    return {row["library"]: row["pip"] for row in rows("shown_with")}


@dataclass(frozen=True, kw_only=True, slots=True)
class _Call:
    """A call that opens a window."""

    library: str
    hints: Hints
    pattern: re.Pattern[str]


@cache
def _calls(language: str) -> Search[_Call]:
    found = (
        record(_Call, row, hints=hints(row["hints"]), pattern=pattern(row["pattern"], re.MULTILINE))
        for row in rows("window_calls")
        if row["language"] == language
    )
    return Search(found, words=language == "python")


def shown(
    text: str, language: Literal["python", "c++"] = "python", words: frozenset[str] = frozenset()
) -> dict[str, int]:
    """Return the libraries by which a file opens windows, each with the place of its first call.

    ``words`` are those of a Python module.
    """
    found: dict[str, int] = {}
    for call in _calls(language).possible(text, words):
        if call.library not in found and (match := call.pattern.search(text)):
            found[call.library] = match.start()
    return found
