"""What the calls of ``glob`` in a setup.py take of a folder: a launch file of another ending is not installed."""

from __future__ import annotations

import re
from fnmatch import fnmatch

from roslab.values.pattern import pattern

MOST = 64
"""Most such calls that are looked at: a build of more may take any file."""
_GLOB = pattern(r"(?P<of>[\w)\]]\.)?\bi?glob\s*\(")
_STRING = r"[rR]?[\"']([^\"'\n{}]*)[\"']"
_LITERAL = pattern(
    rf"\s*(?:{_STRING}|(?:os\.)?(?:path\.)?join\(\s*{_STRING}\s*,\s*{_STRING}\s*(?:,\s*)?\)|{_STRING}\s*\+\s*{_STRING})\s*(?:,\s*)?\)"
)
"""One argument that is written out: whole, of two parts that are joined, or of two that are added."""


def left_by_globs(place: str, name: str, setup: str) -> bool:
    """Tell whether calls of ``glob`` take files of a folder, ``place``, and none of them takes one called ``name``.

    ``setup``: the text of the setup.py without comments. A call whose argument is not written out may take any.
    """
    taken: list[str] = []
    for match in _GLOB.finditer(setup):
        if match["of"] and not setup.endswith("glob.", 0, match.end("of")):
            return False  # a method of a path
        literal = _LITERAL.match(setup, match.end())
        if literal is None or len(taken) == MOST:
            return False
        taken.append(_joined(literal))
    here = [each.removeprefix("./") for each in taken]
    return any(each.rpartition("/")[0] == place for each in here) and not any(
        fnmatch(f"{place}/{name}", each) for each in here
    )


def _joined(literal: re.Match[str]) -> str:
    whole, first, second, begin, end = literal.groups()
    return whole if whole is not None else f"{first.rstrip('/')}/{second}" if first is not None else f"{begin}{end}"
