r"""Patterns written so that the word which they begin with is looked for: ``\bgit\b`` as ``git(?<=\bgit)\b``.

Python tries a pattern at each character of a text, but where it begins with letters it looks for these first, which is
some thirty times faster. What stands before the letters and takes no character itself (``\b``, ``^``, a lookbehind)
hides them. Behind the word it means the same there, and the match is the same.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.values.kept_patterns import at_once

_NOTHING_BEFORE = at_once(r"(?:\\b|\^|\(\?<[!=](?:\\.|\[\^?\]?(?:\\.|[^\]\\])*\]|[^()\[\]\\|])*\))+")
"""What takes no character at the beginning of a pattern; of lookbehinds those without groups."""
_WORD = at_once(r"(?:[A-Za-z0-9_/,:=;<>!\"' -]|\\[./-])+(?![?*+{])|(?:[A-Za-z0-9_/,:=;<>!\"' -]|\\[./-])(?![?*+{])")
_GROUP = at_once(r"\((?:\?:|(?!\?))")
_PART = at_once(r"\\.|\[\^?\]?(?:\\.|[^\]\\])*\]|[()|]|[^\\\[()|]+", re.DOTALL)
"""A part of a pattern that belongs together, or what opens, parts and closes a group."""
_INLINE = at_once(r"\(\?[a-zA-Z]+\)")


def word_first(source: str, flags: int) -> str:
    """Return a pattern that finds the same, and that begins with a word if each of its alternatives has one."""
    inline = _INLINE.match(source)
    said = inline[0] if inline else ""
    if flags & (re.IGNORECASE | re.VERBOSE) or set("ix") & set(said):
        return source
    multiline = bool(flags & re.MULTILINE) or "m" in said
    return said + "|".join(_turned(each, multiline=multiline) for each in _alternatives(source[len(said) :]))


def _turned(source: str, *, multiline: bool) -> str:
    """Return one alternative with its word first."""
    before = _NOTHING_BEFORE.match(source)
    if not before or ("^" in before[0] and not multiline):
        return source
    return _behind(before[0], source[before.end() :]) or source


def _behind(before: str, source: str) -> str | None:
    """Return a pattern with what stood before it behind the word that it, or each of its group, begins with."""
    if word := _WORD.match(source):
        return f"{word[0]}(?<={before}{word[0]}){source[word.end() :]}"
    opened = _GROUP.match(source)
    end = _closed(source) if opened else 0
    if not opened or source[end : end + 1] in {"?", "*", "+", "{"}:
        return None
    each = [_behind(before, part) for part in _alternatives(source[opened.end() : end - 1])]
    turned = [part for part in each if part]
    return f"{opened[0]}{'|'.join(turned)}{source[end - 1 :]}" if len(turned) == len(each) else None


def _alternatives(source: str) -> Iterator[str]:
    """Yield what the bars part that stand in no group."""
    depth = start = 0
    for part in _PART.finditer(source):
        if part[0] == "|" and depth == 0:
            yield source[start : part.start()]
            start = part.end()
        depth += {"(": 1, ")": -1}.get(part[0], 0)
    yield source[start:]


def _closed(source: str) -> int:
    """Return where the group ends that a pattern begins with."""
    depth = 0
    for part in _PART.finditer(source):
        depth += {"(": 1, ")": -1}.get(part[0], 0)
        if depth == 0:
            return part.end()
    return len(source)
