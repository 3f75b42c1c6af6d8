"""Names in which one letter stands for a number: ``demox.launch`` beside ``demo1.launch`` and ``demo2.launch``."""

from __future__ import annotations

import re
from collections.abc import Iterable

from roslab.values.pattern import pattern

_BLANK = pattern(r"([\w./-]*[A-Za-z_-])([xXnNi#*])((?:\.[A-Za-z]\w*)+)")
_NUMBER = pattern(r"\d+")


def numbered(name: str, names: Iterable[str]) -> str:
    """Return the name with the lowest number that a letter in another one, the last before its ending, stands for.

    ``""`` where none of ``names`` fits. A name that is among them is no such; its caller has to know that.
    """
    said = _BLANK.fullmatch(name)
    if said is None:
        return ""
    meant = re.compile(rf"{re.escape(said[1])}(\d+){re.escape(said[3])}")
    found = [(int(match[1]), match[0]) for match in map(meant.fullmatch, names) if match]
    return min(found, default=(0, ""))[1]


def first_of_its_kind(name: str, names: Iterable[str]) -> str:
    """Return the name with the lowest number of those that differ from ``name`` in a number alone, else itself."""
    kind = _NUMBER.sub("0", name)
    same = [each for each in names if _NUMBER.sub("0", each) == kind]
    return min(same, key=lambda each: [int(number) for number in _NUMBER.findall(each)], default=name)
