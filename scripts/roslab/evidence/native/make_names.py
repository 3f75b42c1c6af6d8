"""Names that a Makefile writes as variables, ``$(MAIN): main.o``, in place of which stands what they are set to.

https://www.gnu.org/software/make/manual/html_node/Using-Variables.html, read 2026-11-28.
"""

from __future__ import annotations

import re

from roslab.evidence.lex import make_tasks
from roslab.values.pattern import pattern

_WORD = r"[\w./-]{0,60}\$(?:\(\w{1,60}\)|\{\w{1,60}\})(?:[\w./-]|\$\(\w{1,60}\)|\$\{\w{1,60}\}){0,60}"
_NAMED = pattern(rf"^{_WORD}(?=[ \t]{{0,8}}:(?!=))|(?<=[ \t]-o )[ \t]{{0,8}}{_WORD}(?=\s|$)", re.MULTILINE)
"""What a rule makes, and what a compiler is told to write."""
_NAMES = pattern(r"[\w.-][\w./ -]{0,300}")
MOST = 200


def with_names(text: str) -> str:
    """Return a Makefile with the names of what its rules make in the place of their variables, where it sets these."""
    if not _NAMED.search(text):
        return text
    tasks = make_tasks.parsed(text)

    def named(match: re.Match[str]) -> str:
        name = tasks.filled(match[0], {})
        return name if _NAMES.fullmatch(name) else match[0]

    return _NAMED.sub(named, text, count=MOST)
