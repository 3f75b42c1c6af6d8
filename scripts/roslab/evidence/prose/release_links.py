"""The release of a repository that a page means where it links to it, by its tag or in words behind the link."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

BEFORE = 240
"""Most characters of a sentence before a link."""
_BEHIND = pattern(
    r"(?:\.git)?\)?[ \t]{0,3}(?:@|[,:]?[ \t]{0,3}\(?(?:tag|version|release|v(?=[. ]?\d))[:=.]?)[ \t]{0,3}[`\"'*]{0,2}"
    r"(v?\d{1,8}(?:\.\d{1,4}){1,3}(?:(?:a|b|rc|alpha|beta)\d{1,3})?)(?![\w-]|\.\d)",
    re.IGNORECASE,
)
"""``[GTSAM](https://…/gtsam) @ `4.2a8` ``, ``… (version 4.0.3)``."""
_AND_NEWER = pattern(
    r"[`\"'*\])]{0,3}(?:\([^()\s]{0,200}\))?[ \t]{0,3}(?:\+|\(?(?:or|and)\s+(?:newer|later|above|higher|greater|up)\b)"
)
_OTHERWISE = pattern(
    r"\b(?:fix(?:ed|es)?|included|introduced|added|since|until|before|after|older|newer|if|not|instead|deprecated|"
    r"changelog|optional\w*)\b(?:[^.\n]|\.(?=\S)){0,120}$",
    re.IGNORECASE,
)
"""A sentence in which a release is not the one to take, up to the link."""


def meant(text: str, start: int, end: int) -> bool:
    """Tell whether a page has the reader take the very release that it links to between two places."""
    if text[max(0, start - 3) : start].rstrip("(<").endswith("+]"):
        return False
    return not _AND_NEWER.match(text, end) and not _OTHERWISE.search(text[max(0, start - BEFORE) : start])


def named(text: str, start: int, end: int) -> str:
    """Return the release that stands right behind a link, ``""`` for none, or where a newer one will do."""
    match = _BEHIND.match(text, end)
    if match is None or not meant(text, start, match.end()):
        return ""
    return match[1].lower().removeprefix("v")
