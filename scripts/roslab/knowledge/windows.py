"""Libraries that open windows, and calls that do."""

from __future__ import annotations

import re
from functools import cache
from typing import Literal

from roslab.knowledge.hints import Hints, hints
from roslab.knowledge.table import rows
from roslab.values.pattern import pattern


@cache
def _patterns() -> dict[str, tuple[re.Pattern[str], ...]]:
    kinds = dict.fromkeys(row["where"] for row in rows("windows"))
    return {kind: tuple(pattern(row["pattern"]) for row in rows("windows") if row["where"] == kind) for kind in kinds}


def opens(where: str, name: str) -> bool:
    """Tell whether a library opens windows, by its name for ``find_package``, its header or its Python module."""
    return any(each.search(name) for each in _patterns().get(where, ()))


@cache
def _calls(language: str) -> tuple[tuple[str, Hints, re.Pattern[str]], ...]:
    return tuple(
        (row["library"], hints(row["hints"]), pattern(row["pattern"], re.MULTILINE))
        for row in rows("window_calls")
        if row["language"] == language
    )


def shown(text: str, language: Literal["python", "c++"] = "python") -> dict[str, int]:
    """Return the libraries by which a file opens windows, each with the place of its first call."""
    found: dict[str, int] = {}
    for library, hinted, each in _calls(language):
        if library in found or not (hinted.stand_in(text) if language == "python" else hinted.are_part_of(text)):
            continue
        if match := each.search(text):
            found[library] = match.start()
    return found
