"""Arguments that a launch file gives one that it includes, where they decide about parts of it: ``true``, ``false``.

https://wiki.ros.org/roslaunch/XML/include, read 2026-11-27.
"""

from __future__ import annotations

import re

from roslab.evidence.lex.attributes import attributes
from roslab.evidence.ros.argument_defaults import ARGUMENT
from roslab.values.pattern import pattern

Given = tuple[tuple[str, str], ...]
"""Names and values, sorted."""
_OPENED = pattern(r"<include\b[^<>]{0,900}\Z")
_INSIDE = pattern(r"[^<>]{0,900}[^<>/]>(.{0,4000}?)</include\s?>", re.DOTALL)
_DECIDES = frozenset({"true", "false", "1", "0"})


def given_to(text: str, place: int) -> Given:
    """Return what the ``<include>`` gives whose file is named at a place of a launch file in XML."""
    begin = text.rfind("<", 0, place)
    inside = _INSIDE.match(text, place) if begin >= 0 and _OPENED.match(text, begin, place) else None
    said = (attributes(match[1]) for match in ARGUMENT.finditer(inside[1])) if inside else ()
    pairs = {each.get("name", ""): each.get("value", "") for each in said if not each.keys() & {"if", "unless"}}
    return tuple(sorted((name, value) for name, value in pairs.items() if value.lower() in _DECIDES))


def filled(text: str, given: Given) -> str:
    """Return a launch file with these values in the place of its defaults; its lines stay."""
    values = dict(given)

    def fill(match: re.Match[str]) -> str:
        said = attributes(match[1])
        name = said.get("name", "")
        if name not in values or "value" in said:
            return match[0]
        lines = "\n" * match[0].count("\n")
        return f'<arg name="{name}" default="{values[name]}"{lines}/>'

    return ARGUMENT.sub(fill, text) if values else text
