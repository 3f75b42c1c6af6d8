"""Whether a part of a launch file is started: what the conditions around it say by the defaults of its arguments.

``if`` and ``unless`` of XML: https://wiki.ros.org/roslaunch/XML#if_and_unless_attributes; ``IfCondition`` of Python:
https://docs.ros.org/en/rolling/Tutorials/Intermediate/Launch/Using-Substitutions.html; 2026-11-27.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import NamedTuple

from roslab.evidence.lex.lines import matches_at
from roslab.values.pattern import pattern

NEAR = 300
"""Most characters between a package's name and the end of the call or element that it belongs to."""
_IF = pattern(r"(?<=\s)(if|unless)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')?")
_IFS = ("if", "unless")
"""What its matches begin with."""
_GROUP = pattern(r"<group\b[^>]{0,600}>|</group\b")
_ACTIONS = "Node IncludeLaunchDescription ExecuteProcess LaunchDescription GroupAction DeclareLaunchArgument"
_ACTION = pattern("|".join(rf"{name}\((?<!\w{name}\()" for name in _ACTIONS.split()))
"""Each is a whole word; its letters are found much faster than the edge of a word."""
ARGUMENT = pattern(r"<arg\s((?:[^<>\"']|\"[^\"<]{0,600}\"|'[^'<]{0,600}'){0,900})>")
ATTRIBUTES = pattern(r"([\w-]{1,40})\s{0,9}=\s{0,9}(?:\"([^\"]*)\"|'([^']*)')")
_REFERENCE = pattern(r"\$\(\s?(?:arg|var)\s+(\w+)\s?\)")
_DECLARED = pattern(
    r"DeclareLaunchArgument\(\s{0,99}(?:name\s?=\s?)?[\"']([\w.-]{1,60})[\"']\s?,[^()]{0,600}?"
    r"\bdefault_value\s?=\s?(?:[\"']([^\"']{0,60})[\"'](?=\s{0,99}[,)])|\w)"
)
_CALLED = pattern(
    r"\bcondition\s?=\s?(?:\w+\.)?(If|Unless)Condition\(\s{0,99}"
    r"(?:LaunchConfiguration\(\s{0,99}[\"'](\w+)[\"']\s{0,99}\)|(\w+)|[\"'](\w+)[\"'])\s{0,99},?\s{0,99}\)"
)
_VARIABLE = pattern(r"\b(\w+)\s?=\s?LaunchConfiguration\(\s{0,99}[\"'](\w+)[\"']")
_TRUTH = {"true": True, "1": True, "false": False, "0": False}
_MOST = 4
"""Most arguments that are followed, one of which gives the value of the next."""


def conditional(text: str, begin: int, end: int) -> bool:
    """Tell whether what names a package or a program is only started under a condition that may not hold."""
    return started(text, begin, end) is not True


def started(text: str, begin: int, end: int) -> bool | None:
    """Tell whether what names something is started by the defaults; ``None`` where they do not tell."""
    found = [_holds(each) for each in _around(text, begin, end)]
    return False if False in found else None if None in found else True


def kept_by(text: str, begin: int, end: int) -> tuple[tuple[str, str], ...]:
    """Return the arguments that keep what names something from being started, each with the value that does."""
    found: dict[str, str] = {}
    for each in _around(text, begin, end):
        if _holds(each) is False:
            *names, value = _followed(each.written, each.defaults)
            found |= dict.fromkeys(names, value)
    return tuple(found.items())


class _Condition(NamedTuple):
    """What a condition says; it holds where that is true, ``if``, or not true."""

    holds_if: bool
    written: str
    defaults: Mapping[str, str]


def _holds(condition: _Condition) -> bool | None:
    truth = _TRUTH.get(_followed(condition.written, condition.defaults)[-1])
    return truth if truth is None or condition.holds_if else not truth


def _around(text: str, begin: int, end: int) -> Iterator[_Condition]:
    tags, calls = _conditions(text)
    yield from _of_tags(text, begin, end) if tags else ()
    yield from _of_call(text, begin, end) if calls else ()


@cache
def _conditions(text: str) -> tuple[bool, bool]:
    """Tell whether a file has conditions of elements, and of calls; asked only of one that names something."""
    return any(matches_at(_IF, text, *_IFS)), "condition" in text


def _of_tags(text: str, begin: int, end: int) -> Iterator[_Condition]:
    """Yield what the conditions say of the element that names a package and of the groups around it: ``if="…"``."""
    closed = text.find(">", end, end + NEAR)
    tag = text[max(text.rfind("<", 0, begin), begin - NEAR, 0) : closed if closed >= 0 else end + NEAR]
    groups: list[str] = []
    for match in matches_at(_GROUP, text, "<group", "</group"):
        if match.start() >= begin:
            break
        if not match[0].startswith("</"):
            groups += [match[0]] if not match[0].endswith("/>") else []
        elif groups:
            groups.pop()
    for each in (tag, *groups):
        for said in matches_at(_IF, each, *_IFS):
            yield _Condition(said[1] == "if", said[2] or said[3] or "", _defaults(text))


def _of_call(text: str, begin: int, end: int) -> Iterator[_Condition]:
    """Yield what the condition of the call that names a package says: ``condition=IfCondition(…)``."""
    near = text[max(0, begin - 4 * NEAR) : end + 4 * NEAR]
    if "condition" not in near or "condition=" not in near.replace(" ", ""):
        return
    before = [match.end() for match in _ACTION.finditer(text, max(0, begin - 4 * NEAR), begin)]
    after = _ACTION.search(text, end, end + 4 * NEAR)
    call = text[before[-1] if before else begin : after.start() if after else end + 2 * NEAR]
    if "condition=" not in call.replace(" ", ""):
        return
    said = _CALLED.search(call)
    if said is None:
        yield _Condition(True, "", {})
        return
    name = said[2] or dict(_VARIABLE.findall(text)).get(said[3] or "", "")
    yield _Condition(said[1] == "If", f"$(arg {name})" if name else said[4] or "", _declared(text))


def _followed(written: str, defaults: Mapping[str, str]) -> tuple[str, ...]:
    """Return the arguments that give a value, and it."""
    names: list[str] = []
    while len(names) < _MOST and (named := _REFERENCE.fullmatch(written.strip())):
        names.append(named[1])
        written = defaults.get(named[1], "")
    return (*names, written.strip().lower())


@cache
def _defaults(text: str) -> dict[str, str]:
    """Return the default or value of each argument of an XML file that has one alone."""
    tags = ({name: one or other for name, one, other in ATTRIBUTES.findall(m[1])} for m in ARGUMENT.finditer(text))
    return _alone((said.get("name", ""), said.get("default", said.get("value", ""))) for said in tags)


@cache
def _declared(text: str) -> dict[str, str]:
    """Return the default of each argument that a file in Python declares once."""
    return _alone((match[1], match[2] or "") for match in _DECLARED.finditer(text))


def _alone(said: Iterable[tuple[str, str]]) -> dict[str, str]:
    found: dict[str, str] = {}
    for name, value in said:
        found[name] = value if found.get(name, value) == value else ""
    return found
