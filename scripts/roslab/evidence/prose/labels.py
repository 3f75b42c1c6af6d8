"""A distribution's name alone on a line: what is installed below it is for that distribution."""

from __future__ import annotations

import re

from roslab.evidence.prose.headings import fence, lines_of
from roslab.values.pattern import pattern

_LABEL = pattern(r"[\s>*_`#-]*(?:(?:for|on|under|in)\s+)?[*_`]*([a-z]+)[*_`\s]*(:?)[*_`\s]*", re.IGNORECASE)
_INSTALLS = pattern(
    r"install|set(?:ting)?[-_ ]?up\b|prerequisite|dependenc|requirement|compil|build|ubuntu", re.IGNORECASE
)


def is_label(text: str, start: int, end: int) -> bool:
    """Tell whether the line that holds a name says nothing else, below a title of installation and before a block.

    ``Kinetic:``, ``For kinetic:`` and ``### Kinetic``; the name stands at ``start``.
    """
    first, last = text.rfind("\n", 0, start) + 1, text.find("\n", end)
    match = _LABEL.fullmatch(text[first:last]) if 0 <= last - first < 80 else None
    titled = text.startswith("#", first)
    if match is None or not (match[2] or titled):
        return False
    below = text[last + 1 :].lstrip("\n").partition("\n")[0]
    if not titled and not fence(below):
        return False
    number = text.count("\n", 0, first) + 1
    titles = next((line.titles.values() for line in lines_of(text) if line.number == number), ())
    return any(map(_INSTALLS.search, titles))
