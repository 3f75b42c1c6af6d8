"""What conditions of robot descriptions come to where what they ask for is written out or has a default.

https://github.com/ros/xacro/wiki, ros/xacro (xacro/__init__.py), read 2026-11-28.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import NamedTuple

from roslab.evidence.lex.attributes import attributes
from roslab.evidence.ros import expressions
from roslab.values.pattern import pattern

_PROPERTY = pattern(r"<xacro:(property|arg)\s([^<>]{0,900})>")
_PARAMETER = pattern(r"([*\w]{1,60})(?:\s*:?=\s*(?:'([^']*)'|(\S+)))?(?=\s|$)")
_EXPRESSION = pattern(r"\$\{([^{}]{1,400})\}")
_ARGUMENT = pattern(r"\$\(arg\s+(\w{1,60})\s*\)")
_OF_ARGUMENT = "arg_"
"""What the name of an argument has before it in an expression, in which properties have theirs as they are."""
Values = Mapping[str, str]


class Condition(NamedTuple):
    """What an element says; what it holds is read where that is true, or where it is not."""

    holds_if: bool
    value: str


def holds(conditions: Collection[Condition], values: Values) -> bool:
    """Tell whether all of them are known to hold."""
    return all(expressions.truth(value_of(each.value, values)) is each.holds_if for each in conditions)


def value_of(written: str, values: Values) -> str | None:
    """Return what an attribute comes to, ``None`` where that is not known."""
    named = _ARGUMENT.fullmatch(written.strip())
    if named:
        return values.get(_OF_ARGUMENT + named[1])
    if said := _EXPRESSION.fullmatch(written.strip()):
        return expressions.result(_ARGUMENT.sub(rf"{_OF_ARGUMENT}\1", said[1]), values.get)
    return None if "$" in written else written


def declared(text: str, given: Collection[str]) -> Iterator[tuple[str, str | None]]:
    """Yield the properties and arguments that a text sets, ``None`` for what is not known.

    ``given``: arguments that launch files set.
    """
    for match in _PROPERTY.finditer(text):
        said = attributes(match[2])
        name = said.get("name", "")
        value = said.get("value" if match[1] == "property" else "default")
        if match[1] == "arg":
            value, name = None if name in given else value, _OF_ARGUMENT + name
        yield name, None if value is None or "$" in value else value


def with_declared(values: dict[str, str | None], text: str, given: Collection[str]) -> None:
    """Note what a text sets; what is set to two values is not known."""
    for name, value in declared(text, given):
        values[name] = value if values.get(name, value) == value else None


def of_call(parameters: str, call: Mapping[str, str], values: Values) -> dict[str, str]:
    """Return what is known in a macro with these parameters that is called with these attributes."""
    inside = dict(values)
    for name, quoted, plain in _PARAMETER.findall(parameters):
        written = call.get(name, quoted or plain or None)
        value = value_of(written, values) if written is not None and not written.startswith("^") else None
        inside.pop(name, None)
        inside |= {name: value} if value is not None else {}
    return inside
