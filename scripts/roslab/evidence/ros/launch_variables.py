"""Variables of the environment without which a launch file in XML does not start.

``$(env NAME)`` without a value stops roslaunch and ros2 launch at once. ``$(optenv NAME)`` is then empty, which stops
roslaunch where a namespace, a name, a program or a file is called so.
https://wiki.ros.org/roslaunch/XML (substitution args), https://wiki.ros.org/roslaunch/XML/group, 2026-11-25
"""

from __future__ import annotations

import re
from collections.abc import Callable

from roslab.evidence.lex.attributes import attributes
from roslab.values.pattern import pattern

_ENV = pattern(r"\$\(\s*env\s+([A-Za-z_]\w*)\s*\)")
_EMPTY = pattern(r"\$\(\s*optenv\s+([A-Za-z_]\w*)\s*\)")
_ARGUMENT = pattern(r"<arg\s[^<>]{0,300}>")
_MUST = pattern(r"\b(?:ns|name|type|pkg|file)\s{0,9}=\s{0,9}([\"'])\s{0,9}\$\(\s*(arg|optenv)\s+(\w+)\s*\)\s{0,9}\1")
"""An attribute that is nothing but a value, and that must not be empty."""


def needed(text: str, conditional: Callable[[str, int, int], bool]) -> tuple[tuple[str, int], ...]:
    """Return the variables that a launch file in XML needs, each with its line.

    ``conditional`` tells of a part of the text whether a condition decides about it.
    """
    if "env" not in text:
        return ()
    found: dict[str, int] = {}
    for match in _ENV.finditer(text):
        if not conditional(text, match.start(), match.end()):
            found.setdefault(match[1], match.start())
    for name, place in _left_empty(text, conditional):
        found.setdefault(name, place)
    return tuple((name, text.count("\n", 0, place) + 1) for name, place in found.items())


def _left_empty(text: str, conditional: Callable[[str, int, int], bool]) -> list[tuple[str, int]]:
    """Return the variables that may be empty but for what is called after them, each with the place of the latter."""
    if "optenv" not in text:
        return []
    arguments: dict[str, str] = {}
    for match in _ARGUMENT.finditer(text):
        said = attributes(match[0])
        value = _EMPTY.fullmatch(said.get("default", said.get("value", "")).strip())
        if value and "name" in said:
            arguments[said["name"]] = value[1]
    used = [(match, _meant(match, arguments)) for match in _MUST.finditer(text)]
    return [(name, match.start()) for match, name in used if name and not conditional(text, match.start(), match.end())]


def _meant(match: re.Match[str], arguments: dict[str, str]) -> str:
    return match[3] if match[2] == "optenv" else arguments.get(match[3], "")
