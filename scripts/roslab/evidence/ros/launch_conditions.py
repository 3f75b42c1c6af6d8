"""Whether a part of a launch file is started: what the conditions around it say by the defaults of its arguments.

``if`` and ``unless`` of XML: https://wiki.ros.org/roslaunch/XML#if_and_unless_attributes; ``IfCondition`` of Python:
https://docs.ros.org/en/rolling/Tutorials/Intermediate/Launch/Using-Substitutions.html; 2026-11-27.
"""

from __future__ import annotations

import sys
from bisect import bisect_left
from collections.abc import Iterable, Iterator, Mapping
from functools import cache

from roslab.evidence.launch_file import When
from roslab.evidence.lex.lines import matches_at
from roslab.evidence.ros import expressions
from roslab.evidence.ros.argument_defaults import declared, defaults, variables
from roslab.evidence.ros.launch_expressions import expression
from roslab.values.pattern import pattern

NEAR = 300
"""Most characters between a package's name and the end of the call or element that it belongs to."""
_IF = pattern(r"(?<=\s)(if|unless)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')?")
_IFS = ("if", "unless")
"""What its matches begin with."""
_GROUP = pattern(r"<group\b[^>]{0,600}>|</group\b")
_TOKEN = pattern(
    r"\"\"\"[\s\S]*?\"\"\"|'''[\s\S]*?'''|\"(?:[^\"\\\n]|\\.)*\"|'(?:[^'\\\n]|\\.)*'|#[^\n]*|[()]|"
    r"condition(?<!\wcondition)\s?=(?!=)"
)
"""What tells where a call of Python ends and what condition it has; brackets in strings and comments do not."""
_CALLED = pattern(
    r"\bcondition\s?=\s?(?:\w+\.)?(If|Unless)Condition\(\s{0,99}"
    r"(?:LaunchConfiguration\(\s{0,99}[\"'](\w+)[\"']\s{0,99}\)|(\w+)|[\"'](\w+)[\"'])\s{0,99},?\s{0,99}\)"
)
_DEEPEST = 20
"""Most conditions around something, and most defaults that decide one, that are looked at."""
_Around = tuple[When, ...]
_Places = tuple[list[int], list[_Around]]
"""Where something begins or ends, and the conditions that are around what follows."""


def conditional(text: str, begin: int, end: int) -> bool:
    """Tell whether what names a package or a program is only started under a condition that may not hold."""
    return started(text, begin, end) is not True


def started(text: str, begin: int, end: int) -> bool | None:
    """Tell whether what names something is started by the defaults; ``None`` where they do not tell."""
    found = {holds(each, {}) for each in _around(text, begin, end)}
    return False if False in found else None if None in found else True


def kept_by(text: str, begin: int, end: int) -> tuple[tuple[str, str], ...]:
    """Return the arguments that keep what names something from being started, each with the value that does."""
    found: dict[str, str] = {}
    for each in _around(text, begin, end):
        if holds(each, {}) is False:
            values = _Values({}, dict(each.defaults))
            known = {name: value for name, _ in each.defaults if (value := values.of(name)) is not None}
            found |= {name: value.lower() for name, value in known.items()}
    return tuple(found.items())


def decided_by(text: str, begin: int, end: int) -> tuple[When, ...]:
    """Return the conditions around something that values of arguments decide."""
    return tuple(_around(text, begin, end))


def holds(when: When, given: Mapping[str, str]) -> bool | None:
    """Tell whether a condition holds for arguments with these values, ``None`` where they do not tell."""
    truth = expressions.truth(expressions.result(when.expression, _Values(given, dict(when.defaults)).of))
    return truth if truth is None or when.holds_if else not truth


def _when(holds_if: bool, text: str, defaults: Mapping[str, str]) -> When:
    """Return the condition that an expression says, with the defaults that may decide it."""
    asked = [*expressions.names(text)]
    found: dict[str, str] = {}
    for name in asked:
        if name in defaults and name not in found and len(found) < _DEEPEST:
            found[name] = defaults[name]
            asked += expressions.names(expression(found[name]))
    return When(holds_if, text, tuple(found.items()))


class _Values:
    """The values of arguments that are ``given`` or have ``defaults``."""

    def __init__(self, given: Mapping[str, str], defaults: Mapping[str, str]) -> None:
        self._defaults = defaults
        self._known: dict[str, str | None] = dict(given)

    def of(self, name: str) -> str | None:
        """Return the value of an argument, ``None`` where nothing tells it."""
        if name not in self._known:
            self._known[name] = None  # one that has its value from itself has none
            if (written := self._defaults.get(name)) is not None:
                self._known[name] = expressions.result(expression(written), self.of)
        return self._known[name]


def _around(text: str, begin: int, end: int) -> Iterator[When]:
    """Yield the conditions of what names something, and of all that is around it."""
    tags, calls = _conditions(text)
    yield from (*_of_tag(text, begin, end), *_at(_groups(text), begin)) if tags else ()
    yield from _at(_calls(text), begin) if calls else ()


@cache
def _conditions(text: str) -> tuple[bool, bool]:
    """Tell whether a file has conditions of elements, and of calls; asked only of one that names something."""
    called = "condition" in text and "condition=" in text.replace(" ", "")
    return any(matches_at(_IF, text, *_IFS)), called


def _of_tag(text: str, begin: int, end: int) -> Iterator[When]:
    """Yield the conditions of the element that names a package: ``if="…"``."""
    closed = text.find(">", end, end + NEAR)
    first = max(begin - NEAR, 0)
    yield from _ifs(text[max(text.rfind("<", first, begin), first) : closed if closed >= 0 else end + NEAR], text)


def _ifs(tag: str, text: str) -> Iterator[When]:
    for said in matches_at(_IF, tag, *_IFS):
        holds_if = said[1] == "if"
        for part in expressions.parts(expression(said[2] or said[3] or ""), holds_if=holds_if):
            yield _when(holds_if, part, defaults(text))


def _at(places: _Places, begin: int) -> _Around:
    """Return the conditions around a place."""
    number = bisect_left(places[0], begin)
    return places[1][number - 1] if number else ()


@cache
def _groups(text: str) -> _Places:
    """Return the places of the groups of an XML file."""
    places: list[int] = []
    said: list[_Around] = []
    groups: list[_Around] = [()]
    for match in matches_at(_GROUP, text, "<group", "</group"):
        if not match[0].startswith("</"):
            groups += [] if match[0].endswith("/>") else [(*groups[-1], *_ifs(match[0], text))[:_DEEPEST]]
        elif len(groups) > 1:
            groups.pop()
        places.append(match.start())
        said.append(groups[-1])
    return places, said


@cache
def _calls(text: str) -> _Places:
    """Return the places of the calls of a file in Python that have a condition: ``condition=IfCondition(…)``."""
    ends: list[tuple[int, int, _Around]] = []
    calls: list[tuple[int, list[When]]] = []
    for match in _TOKEN.finditer(text):
        if match[0] == "(":
            calls.append((match.start(), []))
        elif match[0].startswith("condition") and calls:
            calls[-1][1].append(_of_call(text, match.start()))
        elif match[0] == ")" and calls:
            begin, said = calls.pop()
            ends += [(begin, match.start(), (*said,))] if said else []
    return _nested(sorted(ends, key=lambda each: each[0]))


def _nested(spans: Iterable[tuple[int, int, _Around]]) -> _Places:
    """Return the places of spans in the order of their beginnings, each of which lies beside or in another one."""
    changes: dict[int, _Around] = {}
    inside: list[tuple[int, _Around]] = [(sys.maxsize, ())]
    for begin, end, said in (*spans, (sys.maxsize, sys.maxsize, ())):
        while inside[-1][0] < begin:
            place, _ = inside.pop()
            changes[place] = inside[-1][1]
        inside.append((end, (*inside[-1][1], *said)[:_DEEPEST]))
        changes[begin] = inside[-1][1]
    return [*changes], [*changes.values()]


def _of_call(text: str, begin: int) -> When:
    """Return a condition of a call."""
    said = _CALLED.match(text, begin)
    if said is None:
        return When(True, "", ())
    name = said[2] or variables(text).get(said[3] or "", "")
    return _when(said[1] == "If", expression(f"$(arg {name})" if name else said[4] or ""), declared(text))
