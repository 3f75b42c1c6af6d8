"""The items of the lists in which a page says what is needed before it is installed."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.prose.headings import MAX_LINE, Line, lines_of
from roslab.values.pattern import pattern

LISTS = pattern(r"\b(?:requirements?|required|dependenc(?:y|ies)|prerequisites?|pre-requisites?)\b", re.IGNORECASE)
"""The title above a list of what is needed, or the line before it, which ends in a colon."""
_ITEM = pattern(r"^\s{0,8}(?:[-*+]|\d{1,2}[.)])\s")
_UNASKED = pattern(
    r"\b(?:optional\w*|not|without|instead|alternativ\w*|recommend\w*|only (?:if|for)|if|tests?|testing|docs?)\b|n't\b",
    re.IGNORECASE,
)


def needed_items(text: str) -> Iterator[Line]:
    """Yield the lines of a page that are such items, without those that not everybody needs."""
    before = ""
    for line in lines_of(text):
        if not _ITEM.match(line.text[:20]):
            before = line.text[:MAX_LINE] if line.text.strip() else before
            continue
        lead = [before] if before.rstrip(" *_").endswith(":") else []
        above = [*lead, *line.titles.values()]
        if line.fenced or line.elsewhere or len(line.text) > MAX_LINE or not any(map(LISTS.search, above)):
            continue
        if not any(map(_UNASKED.search, (line.text, *above))):
            yield line
