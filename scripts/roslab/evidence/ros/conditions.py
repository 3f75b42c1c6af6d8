"""Conditions of package.xml format 3. https://ros.org/reps/rep-0149.html#dependency-conditions.

catkin_pkg has a parser for them, but it needs pyparsing, raises at the first odd condition and has no bounds.
"""

from __future__ import annotations

from collections.abc import Mapping

from roslab.values.pattern import pattern

_TOKEN = pattern(r"\s*(\(|\)|==|!=|<=|>=|<|>|\band\b|\bor\b|\$\w+|\"[^\"]*\"|'[^']*'|[\w.+-]+)")
MAX_TOKENS = 60
MAX_LENGTH = 1_000
_COMPARE = {"==": str.__eq__, "!=": str.__ne__, "<": str.__lt__, ">": str.__gt__, "<=": str.__le__, ">=": str.__ge__}


def holds(condition: str | None, variables: Mapping[str, str]) -> bool:
    """Tell whether a condition is true; one that cannot be read counts as true, and so does a missing one."""
    if not condition:
        return True
    tokens = _TOKEN.findall(condition[:MAX_LENGTH])
    if len(tokens) > MAX_TOKENS or "".join(tokens) != "".join(condition.split()):
        return True
    try:
        value, rest = _either(tokens, variables)
    except (IndexError, ValueError):
        return True
    return value if not rest else True


def _either(tokens: list[str], variables: Mapping[str, str]) -> tuple[bool, list[str]]:
    value, rest = _both(tokens, variables)
    while rest and rest[0] == "or":
        other, rest = _both(rest[1:], variables)
        value = value or other
    return value, rest


def _both(tokens: list[str], variables: Mapping[str, str]) -> tuple[bool, list[str]]:
    value, rest = _one(tokens, variables)
    while rest and rest[0] == "and":
        other, rest = _one(rest[1:], variables)
        value = value and other
    return value, rest


def _one(tokens: list[str], variables: Mapping[str, str]) -> tuple[bool, list[str]]:
    if tokens[0] == "(":
        value, rest = _either(tokens[1:], variables)
        if rest[0] != ")":
            raise ValueError(rest[0])
        return value, rest[1:]
    left, operator, right = _value(tokens[0], variables), tokens[1], _value(tokens[2], variables)
    if operator not in _COMPARE:
        raise ValueError(operator)
    return _COMPARE[operator](left, right), tokens[3:]


def _value(token: str, variables: Mapping[str, str]) -> str:
    return variables.get(token[1:], "") if token.startswith("$") else token.strip("\"'")
