"""Whether a place of Python lies in a comment."""

from __future__ import annotations

from roslab.values.pattern import pattern

NEAR = 2_000
"""Most characters of a line before a place that are looked at."""
_STRING = pattern(r"\"(?:[^\"\\]|\\.)*(?:\"|\Z)|'(?:[^'\\]|\\.)*(?:'|\Z)")
"""One of a line, which may end after the place."""


def in_comment(text: str, position: int) -> bool:
    """Tell whether a hash that is in no string begins a comment at or before a position of its line."""
    line = text[max(text.rfind("\n", 0, position) + 1, position - NEAR) : position + 1]
    return "#" in line and "#" in _STRING.sub("", line)
