"""The arguments that a launch file declares without a default: whoever starts it has to give them."""

from __future__ import annotations

from roslab.evidence.launch_file import Demand
from roslab.evidence.lex.attributes import attributes
from roslab.evidence.lex.lines import matches_at
from roslab.evidence.ros.argument_defaults import ARGUMENT
from roslab.evidence.ros.launch_conditions import decided_by
from roslab.values.pattern import pattern

_DECLARED = pattern(
    r"DeclareLaunchArgument\(((?:[^()\"']|\"[^\"\n]{0,600}\"|'[^'\n]{0,600}'|\((?:[^()]|\([^()]{0,200}\)){0,600}\)){0,900})\)"
)
_DECLARED_NAME = pattern(r"\s{0,99}(?:name\s?=\s?)?[\"']([\w.-]{1,60})[\"']")
_OPTIONAL = pattern(r"\b(?:default(?:_value)?|condition)\s?=|\*\*")
"""What makes an argument one that may be left out, or that may be declared in a way that is not seen."""


def in_xml(text: str) -> tuple[Demand, ...]:
    """Return those of an XML file, each with the conditions of the groups around it.

    In ROS 1 (https://wiki.ros.org/roslaunch/XML/arg) and 2, 2026-11-23. Those with a condition of their own are left
    out.
    """
    found: dict[Demand, None] = {}
    for match in matches_at(ARGUMENT, text, "<arg"):
        said = attributes(match[1])
        if said.get("name") and not said.keys() & {"default", "value", "if", "unless"}:
            found[_demand(said["name"], match.start(1), text)] = None
    return tuple(found)


def in_python(text: str) -> tuple[Demand, ...]:
    """Return those of a file in Python, each with the conditions of the calls around it.

    https://docs.ros.org/en/rolling/Tutorials/Intermediate/Launch/Using-Substitutions.html, 2026-11-23.
    """
    found: dict[Demand, None] = {}
    for match in matches_at(_DECLARED, text, "DeclareLaunchArgument"):
        name = None if _OPTIONAL.search(match[1]) else _DECLARED_NAME.match(match[1])
        if name:
            found[_demand(name[1], match.start(), text)] = None
    return tuple(found)


def _demand(name: str, place: int, text: str) -> Demand:
    return Demand(name=name, conditions=decided_by(text, place, place))
