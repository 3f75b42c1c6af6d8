"""Versions that a page says do not work: ``does not run with Python 3.8 or higher``."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_WORKS = r"(?:work|run|support|compile|build|install)\w*|compatible|tested"
_NOT = r"(?:\b(?:not|never|cannot)|n['\u2019]t)"
_BEFORE = pattern(
    rf"(?:{_NOT}(?:\s+(?:yet|been|be|currently|fully|guaranteed to|possible to))*\s+(?:{_WORKS})"
    r"|\b(?:unsupported|incompatible|fails?|breaks?)(?:\s+to\s+(?:run|build|compile|install))?)"
    r"(?:\s+(?:on|with|under|in|for|by))?\s+(?:the\s+)?[`*_]{0,3}\Z",
    re.IGNORECASE,
)
"""What denies the version that follows it."""
_NEWER = r"(?:or|and)\s+(?:newer|later|above|higher|greater|up(?:wards)?|more recent)|\+"
_OLDER = r"(?:or|and)\s+(?:lower|older|below|earlier|previous)"
_SIDE = pattern(
    rf"(?:\.\d+|\.x)?[`*_]{{0,3}}\s*\(?(?:(?P<newer>{_NEWER})|(?P<older>{_OLDER}))?(?:\s+versions?)?\)?", re.IGNORECASE
)
"""The versions around it that are denied too."""
_AFTER = pattern(
    rf"\s*(?:(?:is|are|does|do|did|will|may|might|would|can|could)\s*{_NOT}"
    rf"(?:\s+(?:yet|been|be|currently|fully))*\s+(?:{_WORKS})"
    r"|(?:is|are)\s+(?:currently\s+)?(?:unsupported|incompatible)|(?:fails?|breaks?)\b)",
    re.IGNORECASE,
)
"""What denies the version before it."""
_FARTHEST = 80


def denied(text: str, start: int, end: int) -> str:
    """Return which versions a page denies around a number, ``""`` where it does not deny that one.

    ``start`` and ``end`` are where the name and its number stand. ``<`` says that older ones alone are left,
    ``>`` newer ones, ``!=`` all others.
    """
    side = _SIDE.match(text, end)
    after = side.end() if side else end
    before = text[max(text.rfind("\n", 0, start), start - _FARTHEST, 0) : start]
    if not (_BEFORE.search(before) or _AFTER.match(text, after, after + _FARTHEST)):
        return ""
    return "<" if side and side["newer"] else ">" if side and side["older"] else "!="
