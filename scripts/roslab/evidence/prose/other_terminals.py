"""Commands for a second terminal where the page only says in words what runs in the first: they need that one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from roslab.evidence.facts import Mention
from roslab.evidence.prose.headings import MAX_LINE, lines_of
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_OTHER = pattern(
    r"\b(?:in|from|open(?:ing)?|on)\s+(?:an?other|a (?:second|new|different|separate)|other|the other)\s+"
    r"(?:(?:new|separate|command|bash)\s+)?(?:terminal|shell|console|tab|window|prompt)s?\b",
    re.IGNORECASE,
)
_STARTS = pattern(r"\b(?:run|start|launch|execute)\b", re.IGNORECASE)
_CODE = pattern(r"`[^`]+`|^\s*(?:\$|>|sudo|ros\w+|python[\d.]*|bash|sh|\./\S+|docker)(?:\s|$)")


def other_terminals(commands: Iterable[Mention], texts: Mapping[str, str]) -> Iterator[Mention]:
    """Yield such commands as ``withheld``: their section starts something in a sentence and runs nothing before.

    ``texts``: those of the pages of the ``commands``, by their files.
    """
    here: dict[str, dict[int, Mention]] = {}
    for mention in commands:
        here.setdefault(mention.file, {})[mention.line] = mention
    for file, text in texts.items():
        if _OTHER.search(text):
            for line in _lines(text, frozenset(here.get(file, ()))):
                yield replace(here[file][line], topic="withheld")


def _lines(text: str, commands: frozenset[int]) -> Iterator[int]:
    """Yield the numbers of the lines below such a sentence that are among the ``commands``."""
    started = shown = other = False
    for line in lines_of(text):
        words = line.text[:MAX_LINE]
        if line.heading:
            started = shown = other = False
        elif line.number in commands:
            if other and started and not shown:
                yield line.number
            else:
                shown = True
        elif line.fenced or _CODE.search(words):
            shown = shown or not other
        elif words.strip():
            if not other and _OTHER.search(words):
                other = True
            elif not other:
                started = started or bool(_STARTS.search(words))
