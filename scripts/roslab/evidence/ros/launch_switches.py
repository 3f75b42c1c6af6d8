"""Arguments with which a launch file of ROS 1 is started without what it includes of another package.

``<include if="$(arg simulate)" file="$(find simulator)/…">``: https://wiki.ros.org/roslaunch/XML/include, 2026-11-27.
"""

from __future__ import annotations

from roslab.evidence.lex.attributes import attributes
from roslab.evidence.ros.argument_defaults import ARGUMENT
from roslab.values.pattern import pattern

_INCLUDE = pattern(r"<include\s([^<>]{0,900})>")
_FILE = pattern(r"\$\(\s?find\s+([a-z][a-z0-9_-]{1,60})\s?\)")
_SWITCH = pattern(r"\$\(\s?arg\s+(\w+)\s?\)")
_ON = frozenset({"true", "1"})


def switches(text: str) -> tuple[tuple[str, str], ...]:
    """Return package and argument of what is included alone where an argument is true, as it is by default.

    Not those of which something else is named beside that.
    """
    if "<include" not in text or "if=" not in text:
        return ()
    said = [attributes(match[1]) for match in ARGUMENT.finditer(text)]
    on = {each.get("name", "") for each in said if each.get("default", "").lower() in _ON}
    found: dict[str, str] = {}
    behind: dict[str, int] = {}
    for match in _INCLUDE.finditer(text):
        tag = attributes(match[1])
        named, switch = _FILE.match(tag.get("file", "")), _SWITCH.fullmatch(tag.get("if", ""))
        if named and switch and switch[1] in on and found.setdefault(named[1], switch[1]) == switch[1]:
            behind[named[1]] = behind.get(named[1], 0) + match[1].count(named[0])
    named_at_all = [match[1] for match in _FILE.finditer(text)]
    alone = (name for name in found if named_at_all.count(name) == behind[name])
    return tuple((name, found[name]) for name in alone if f'pkg="{name}"' not in text)
