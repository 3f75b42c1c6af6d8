"""The packages of the plugins that a parameter file names, one by one or in a list."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.lex.lines import matching_lines
from roslab.values.pattern import pattern

_KEY = pattern(
    r"[ \t]{0,99}(?:-[ \t]{0,99})?(?:\{[ \t]{0,99})?(?:name[ \t]*:[ \t]*\S+[ \t]*,[ \t]*)?"
    r"[\"']?(?:type|class|base_(?:local|global)_planner|kinematics_solver|primary_controller|planner_name"
    r"|(?:\w{1,60}_)?plugins?(?:_types?)?|potential_calculator|traceback|trajectory_generator_name"
    r"|(?:request|response)_adapters)[\"']?[ \t]*:"
)
"""The keys of Nav2, of navigation and robot_navigation for ROS 1, of MoveIt, and of what calls its plugins alike."""
_WORDS = ("type", "class", "planner", "kinematics_solver", "primary_controller", "plugin", "potential_calculator")
_MORE = ("traceback", "trajectory_generator", "_adapters")
_VALUE = pattern(
    r"[ \t]*(?:\[(?P<listed>[^\]]{0,4000})\]"
    r"|[>|][-+]?[ \t]*\n(?P<folded>(?:[ \t]+\w{1,60}(?:/|::)[^\n]*(?:\n|\Z))+)"
    r"|(?:#[^\n]*)?(?P<below>(?:\n[ \t]*(?:-|#)[^\n]*){1,60})"
    r"|(?P<one>[^\s#][^\n]*))"
)
_CLASS = pattern(r"(?:^|(?<=[\s,\"'-]))([A-Za-z]\w{1,60})(?:/|::)[A-Z]\w+(?![\w/:.])")
_REMARK = pattern(r"#[^\n]*")


def named(text: str) -> Iterator[tuple[str, int]]:
    """Yield the package of each plugin of a parameter file with its place in the text."""
    for key in matching_lines(_KEY, text, *_WORDS, *_MORE):
        value = _VALUE.match(text, key.end())
        for prefix, place in _prefixes(value) if value else ():
            from roslab.knowledge.plugin_classes import plugin_package  # noqa: PLC0415 - few trees name plugins

            package = plugin_package(prefix)
            if package == package.lower() and package:
                yield package, place


def _prefixes(value: re.Match[str]) -> Iterator[tuple[str, int]]:
    """Yield what stands before the name of each class, with its place; a single value begins with it."""
    group = value.lastgroup or "one"
    whole, start = value[group], value.start(group)
    if group == "one":
        found = _CLASS.match(whole, 1 if whole[0] in "\"'" else 0)
        yield from ((found[1], start + found.start(1)),) if found else ()
        return
    plain = _REMARK.sub(lambda remark: " " * len(remark[0]), whole)
    yield from ((found[1], start + found.start(1)) for found in _CLASS.finditer(plain))
