"""A pyproject.toml that is no valid TOML: pip refuses it for everybody, and most of it says what its author meant."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator
from typing import Any

from roslab.values import toml
from roslab.values.pattern import pattern

_HEADER = pattern(r"^\[\[?[\w.\"' -]+\]\]?[ \t]*(?:#[^\n]*)?$", re.MULTILINE)
_AT = pattern(r" \(at (?:line (\d+), column \d+|end of document)\)$")


def tables(text: str) -> tuple[dict[str, Any], tuple[str, int] | None]:
    """Return the tables that can be read, the first of each name, and what is wrong with the document, and where."""
    try:
        return toml.parsed(text), None
    except ValueError as error:
        at = _AT.search(str(error))
        why = _AT.sub("", str(error)), int(at[1]) if at and at[1] else 1
    kept: dict[str, str] = {}
    for number, (header, part) in enumerate(_parts(text)):
        name = header if header not in kept else f"{header} {number}" if header.startswith("[[") else ""
        if name and _whole(part):
            kept[name] = part
    try:
        return toml.parsed("\n".join(kept.values())), why
    except ValueError:  # two names of one table
        return {}, why


def _parts(text: str) -> Iterator[tuple[str, str]]:
    """Yield each table with its header, the first without one."""
    starts = [0, *(match.start() for match in _HEADER.finditer(text)), len(text)]
    for start, end in itertools.pairwise(starts):
        part = text[start:end]
        match = _HEADER.match(part)
        yield "".join(match[0].partition("#")[0].split()) if match else "", part


def _whole(part: str) -> bool:
    try:
        toml.parsed(part)
    except ValueError:
        return False
    return True
