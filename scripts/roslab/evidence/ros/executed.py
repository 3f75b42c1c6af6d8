"""Programs that a launch file in Python starts beside its nodes: ``ExecuteProcess(cmd=['MicroXRCEAgent', 'udp4'])``.

https://docs.ros.org/en/rolling/p/launch/launch.actions.execute_process.html, 2026-11-27.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import NamedTuple

from roslab.evidence.lex.lines import matches_at
from roslab.values.pattern import pattern

_CALL = pattern(r"\b(?:ExecuteProcess|ExecuteLocal)\(")
_COMMAND = pattern(
    r"[^()]{0,400}?\bcmd\s{0,3}=\s{0,20}(?:\[\s{0,60}(?:#[^\n]{0,200}\n\s{0,60})?[\"']([^\"'\n]{1,200})[\"']|([A-Za-z_]\w{0,60})\b)"
)
"""The first word that it starts, or the name of the list that holds it."""
_FOLDER = pattern(r"\bcwd\s{0,3}=[^,\n]{0,60}?[\"']((?:~|/home/\w+)/[\w./-]{1,200})[\"']")
_PROGRAM = pattern(r"[A-Za-z][\w.+-]{1,60}")
NEAR = 900
"""Most characters of a call."""


class Executed(NamedTuple):
    """A program that is started by its name, with the folder of its author's home in which it is, if any."""

    program: str
    folder: str
    line: int


def executed(text: str, started: Callable[[str, int, int], bool | None]) -> Iterator[Executed]:
    """Yield each such program but for those of paths and variables, unless its condition does not hold."""
    for match in matches_at(_CALL, text, "ExecuteProcess", "ExecuteLocal"):
        if "#" in text[text.rfind("\n", 0, match.start()) + 1 : match.start()]:
            continue  # a remark
        said = _COMMAND.match(text, match.end(), match.end() + NEAR)
        if said is None or started(text, match.start(), said.end()) is False:
            continue
        first = said[1] or _listed(said[2], text)
        words = first.split()
        words = words[1:] if words[:1] == ["sudo"] else words
        if words and _PROGRAM.fullmatch(words[0]):
            folder = _FOLDER.search(text, match.end(), _end(text, match.end()))
            line = text.count("\n", 0, match.start()) + 1
            yield Executed(words[0], folder[1] if folder else "", line)


def _listed(name: str, text: str) -> str:
    """Return the first word of the list that a variable holds, ``""`` where none is written out."""
    made = re.search(rf"^[ \t]{{0,40}}{name}[ \t]?=[ \t]?\[\s{{0,60}}[\"']([^\"'\n]{{1,200}})[\"']", text, re.MULTILINE)
    return made[1] if made else ""


def _end(text: str, begin: int) -> int:
    """Return the place of the bracket that ends a call, as far as it is near."""
    depth = 1
    for place in range(begin, min(len(text), begin + NEAR)):
        depth += {"(": 1, ")": -1}.get(text[place], 0)
        if not depth:
            return place
    return min(len(text), begin + NEAR)
