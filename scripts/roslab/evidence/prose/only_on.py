"""The Ubuntu that a shell script is made for: it asks which one it runs on, and stops on every other."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.knowledge.distros import ubuntu_released, ubuntus
from roslab.values.pattern import pattern

_STEP = pattern(r"[ \t]{0,80}(if|elif|else|fi|exit|return)\b([^\n]{0,400})")
_CLOSED = pattern(r"[;\s]fi\s*(?:[;#&|].*)?$")
_ASKED = pattern(r"\$\{?\w*(?:distrib|release|version|codename|ubuntu)|lsb_release", re.IGNORECASE)
_EQUAL = pattern(r"(?<!!)(?:==?|=~)\s{0,4}[*\"'^(]{0,4}(?:ubuntu[ -]?)?([a-z]{4,9}|\d\d\.\d\d)\b", re.IGNORECASE)


def read(text: str, file: str) -> Iterator[Mention]:
    """Yield the newest Ubuntu of each ``if`` that has a branch for some and whose ``else`` stops the script.

    Only long-term releases count. What just does more on one Ubuntu (``if`` without such an ``else``) tells nothing.
    """
    if "else" not in text or not _ASKED.search(text):
        return
    blocks: list[_Block] = []
    for number, line in enumerate(text.split("\n"), 1):
        step = _STEP.match(line)
        if step is None or (step[1] == "if" and _CLOSED.search(line)):
            continue
        if step[1] == "if":
            blocks.append(_Block())
        if not blocks:
            continue
        block = blocks[-1]
        if step[1] in {"if", "elif"} and _ASKED.search(step[2]):
            for name in _EQUAL.findall(step[2]):
                block.asked.setdefault(ubuntus().get(name, name.lower()), (number, line.strip()))
        block.last = block.last or step[1] == "else"
        block.stops = block.stops or (block.last and step[1] in {"exit", "return"})
        if step[1] == "fi" and blocks.pop().stops:
            known = [name for name in ubuntu_released() if name in block.asked]
            for name in known[-1:]:
                place, said = block.asked[name]
                yield Mention(topic="ubuntu", value=name, source="script", file=file, line=place, text=said)


class _Block:
    """An ``if`` that is being read."""

    def __init__(self) -> None:
        self.asked: dict[str, tuple[int, str]] = {}
        """The releases that its conditions name, each with its line."""
        self.last = False
        self.stops = False
