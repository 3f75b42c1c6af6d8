"""Blocks of a page that list the programs which a build makes: a name on each line, below a line that says so."""

from __future__ import annotations

import re

from roslab.evidence.prose.headings import MAX_LINE, fence
from roslab.values.pattern import pattern

_FEWEST = 2
"""A name that stands alone may be what is to be typed."""
_NAME = pattern(r"\s{0,12}[\w.+-]+\s{0,12}")
_LISTS = pattern(r"\b(?:executables?|binar(?:y|ies)|programs?|targets?)\b", re.IGNORECASE)
_RUNS = pattern(
    r"\b(?:run|runs|running|ran|start\w*|execut(?:e|es|ing)|launch\w*|call\w*|invoke\w*|types?|enter|use|try)\b",
    re.IGNORECASE,
)
"""A line that has its reader do something with them."""


def listing(text: str) -> frozenset[int]:
    """Return the numbers of the lines of such lists: ``The following executables are built:``."""
    if ("```" not in text and "~~~" not in text) or not _LISTS.search(text):
        return frozenset()
    found: set[int] = set()
    block: dict[int, str] = {}
    lead, begun = "", 0
    for number, line in enumerate(text.split("\n"), 1):
        if fence(line):
            lists = begun and len(block) >= _FEWEST and all(map(_NAME.fullmatch, block.values()))
            if lists and _LISTS.search(lead) and not _RUNS.search(lead):
                found |= block.keys()
            lead = "" if begun else lead
            block, begun = {}, 0 if begun else number
        elif line.strip() and begun:
            block[number] = line[:MAX_LINE]
        elif line.strip():
            lead = line[:MAX_LINE]
    return frozenset(found)
