"""Libraries that open windows, and calls that do."""

from __future__ import annotations

import re
from functools import cache
from typing import Literal

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
def _calls(language: str) -> tuple[tuple[str, str, re.Pattern[str]], ...]:
    return tuple(
        (row["library"], row["hint"], pattern(row["pattern"], re.MULTILINE))
        for row in rows("window_calls")
        if row["language"] == language
    )


def shown(text: str, language: Literal["python", "c++"] = "python") -> dict[str, int]:
    """Return the libraries by which a file opens windows, each with the place of its first call."""
    found: dict[str, int] = {}
    for library, hint, each in _calls(language):
        if library not in found and hint in text and (match := each.search(text)):
            found[library] = match.start()
    return found
