"""The paths that a program of Python opens from where it is started, and those that it takes from its own folder."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.values.pattern import pattern

_PATH = pattern(
    r"[\"\']((?:\.{1,2}/)*(?:[\w-]+/)+[\w.-]*|(?:\.{1,2}/)*[\w-]+\.(?:ya?ml|json|csv|txt|np[yz]|xml|urdf|pth?|pkl|png|jpe?g|dat|mat))"
)
"""A file or a folder in a string, or what such a string begins with."""
_OWN = pattern(r"^[ \t]*(\w+)[ \t]*=[^\n]*\b__file__\b", re.MULTILINE)
"""A name for the program's own folder, or for what lies by it."""
_WORD = pattern(r"\w+")
_BEFORE = 200


def paths_in(text: str) -> frozenset[str]:
    """Return the paths that a program names; one behind its own folder (``join(dirname(__file__), "../a")``) is none.

    That is found wherever the program is started.
    """
    own = frozenset({"__file__", *_OWN.findall(text)})
    return frozenset(_free(text, own))


def _free(text: str, own: frozenset[str]) -> Iterator[str]:
    there = "__file__" in text
    for match in _PATH.finditer(text):
        if not (there and _behind(text[max(0, match.start() - _BEFORE) : match.start()], own)):
            yield match[1]


def _behind(before: str, own: frozenset[str]) -> bool:
    """Tell whether a path is put behind the program's own folder, by ``join(…, "a")`` or ``… / "a"``."""
    said = before.rstrip()
    if said.endswith("/"):
        place = said.rpartition("\n")[2]
    else:
        place = said.rpartition("join(")[2] if "join(" in said and said.endswith(",") else ""
    inside = place.count("(") == place.count(")") or said.endswith("/")
    return inside and not own.isdisjoint(_WORD.findall(place))
