"""The release of libtorch that a page names."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.values.pattern import pattern

_NAMED = pattern(r"\blibtorch\b[^\n]{0,60}?(?<![\d.])(\d\.\d{1,2}(?:\.\d)?)(?!\.?\d)")


def read(file: str, text: str) -> Iterator[Mention]:
    """Yield each release that stands behind the name, in a sentence or in the address of an archive."""
    lowered = text.lower()
    for match in _NAMED.finditer(lowered) if "libtorch" in lowered else ():
        line = text.count("\n", 0, match.start()) + 1
        yield Mention(topic="libtorch", value=match[1], source="readme", file=file, line=line, text=match[0])
