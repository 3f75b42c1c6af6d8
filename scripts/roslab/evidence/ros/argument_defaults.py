"""What the arguments of a launch file are by themselves: their defaults and values, in XML and in Python."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cache

from roslab.evidence.lex.attributes import attributes
from roslab.evidence.lex.lines import matches_at
from roslab.values.pattern import pattern

_INCLUDE = pattern(r"<include\b[^>]{0,600}>|</include\b")
ARGUMENT = pattern(r"<arg\s((?:[^<>\"']|\"[^\"<]{0,600}\"|'[^'<]{0,600}'){0,900})>")
REFERENCE = pattern(r"\$\(\s?(?:arg|var)\s+(\w+)\s?\)")
_DECLARED = pattern(
    r"DeclareLaunchArgument\(\s{0,99}(?:name\s?=\s?)?[\"']([\w.-]{1,60})[\"']\s?,[^()]{0,600}?"
    r"\bdefault_value\s?=\s?(?:[\"']([^\"']{0,60})[\"'](?=\s{0,99}[,)])|\w)"
)
_VARIABLE = pattern(r"\b(\w+)\s?=\s?LaunchConfiguration\(\s{0,99}[\"'](\w+)[\"']")


@cache
def defaults(text: str) -> dict[str, str]:
    """Return the default or value, which may be empty, of each argument of an XML file that has one alone."""
    return _alone((said.get("name", ""), said.get("default", said.get("value"))) for said in _arguments(text))


def _arguments(text: str) -> Iterator[dict[str, str]]:
    """Yield the attributes of each argument that is the file's own, and not given to a file that it includes."""
    parts = (*matches_at(ARGUMENT, text, "<arg"), *matches_at(_INCLUDE, text, "<include", "</include"))
    included = False
    for match in sorted(parts, key=lambda match: match.start()):
        if not match[0].startswith("<arg"):
            included = match[0].startswith("<include") and not match[0].endswith("/>")
        elif not included:
            yield attributes(match[1])


@cache
def declared(text: str) -> dict[str, str]:
    """Return the default of each argument that a file in Python declares with one alone, written out."""
    return _alone((match[1], match[2]) for match in matches_at(_DECLARED, text, "DeclareLaunchArgument("))


@cache
def variables(text: str) -> dict[str, str]:
    """Return the argument whose value each variable of a file in Python has."""
    return dict(_VARIABLE.findall(text))


def _alone(said: Iterable[tuple[str, str | None]]) -> dict[str, str]:
    """Return the values of the names that have one alone; ``None`` is one that is not known."""
    found: dict[str, set[str | None]] = {}
    for name, value in said:
        if not _passed_on(name, value or ""):
            found.setdefault(name, set()).add(value)
    return {name: value for name, (value, *others) in found.items() if value is not None and not others}


def _passed_on(name: str, value: str) -> bool:
    """Tell whether an argument has the value that another line gives it."""
    named = REFERENCE.fullmatch(value.strip())
    return named is not None and named[1] == name
