"""The attributes of an element of XML that is read without a parser, as the file may be broken."""

from __future__ import annotations

from roslab.values.pattern import pattern

_ATTRIBUTE = pattern(r"([\w:.-]{1,60})\s{0,9}=\s{0,9}(?:\"([^\"]*)\"|'([^']*)')")


def attributes(element: str) -> dict[str, str]:
    """Return the attributes that the text of an element has, as they are written."""
    return {name: one or other for name, one, other in _ATTRIBUTE.findall(element)}
