"""Whether a part of a launch file is started: what the conditions around it say by the defaults of its arguments.

``if`` and ``unless`` of XML: https://wiki.ros.org/roslaunch/XML#if_and_unless_attributes; ``IfCondition`` of Python:
https://docs.ros.org/en/rolling/Tutorials/Intermediate/Launch/Using-Substitutions.html; 2026-11-27.
"""

from __future__ import annotations

import sys
from bisect import bisect_left
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import NamedTuple

from roslab.evidence.launch_file import When
from roslab.evidence.lex.lines import matches_at
from roslab.values.pattern import pattern

NEAR = 300
"""Most characters between a package's name and the end of the call or element that it belongs to."""
_IF = pattern(r"(?<=\s)(if|unless)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')?")
_IFS = ("if", "unless")
"""What its matches begin with."""
_GROUP = pattern(r"<group\b[^>]{0,600}>|</group\b")
_INCLUDE = pattern(r"<include\b[^>]{0,600}>|</include\b")
_TOKEN = pattern(
    r"\"\"\"[\s\S]*?\"\"\"|'''[\s\S]*?'''|\"(?:[^\"\\\n]|\\.)*\"|'(?:[^'\\\n]|\\.)*'|#[^\n]*|[()]|"
    r"condition(?<!\wcondition)\s?=(?!=)"
)
"""What tells where a call of Python ends and what condition it has; brackets in strings and comments do not."""
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
_EVAL = pattern(r"\$\(\s?eval\s+([^\n]{1,400})\)")
_TERM = pattern(
    r"((?:not\s+)*)(?:arg\(\s?[\"'](\w+)[\"']\s?\)|(\w+)|[\"']\$\(\s?(?:arg|var)\s+(\w+)\s?\)[\"'])"
    r"(?:\s?(==|!=)\s?[\"']([\w.-]+)[\"'])?"
)
"""A term of it that asks for an argument, or compares one: ``not arg('sim')``, ``arg('robot') == 'ur5'``."""
_ARGUMENT_CALL = pattern(r"\barg\([^()]*\)|\$\([^()]*\)")
_TRUTH = {"true": True, "1": True, "false": False, "0": False}
_MOST = 4
"""Most arguments that are followed, one of which gives the value of the next."""
_DEEPEST = 20
"""Most conditions around something that are looked at."""


class _Condition(NamedTuple):
    """What a condition says; it holds where that is true, ``if``, or not true."""

    holds_if: bool
    written: str
    defaults: Mapping[str, str]


_Around = tuple[_Condition, ...]
_Places = tuple[list[int], list[_Around]]
"""Where something begins or ends, and the conditions that are around what follows."""


def conditional(text: str, begin: int, end: int) -> bool:
    """Tell whether what names a package or a program is only started under a condition that may not hold."""
    return started(text, begin, end) is not True


def started(text: str, begin: int, end: int) -> bool | None:
    """Tell whether what names something is started by the defaults; ``None`` where they do not tell."""
    found = {_holds(each) for each in _around(text, begin, end)}
    return False if False in found else None if None in found else True


def kept_by(text: str, begin: int, end: int) -> tuple[tuple[str, str], ...]:
    """Return the arguments that keep what names something from being started, each with the value that does."""
    found: dict[str, str] = {}
    for each in _around(text, begin, end):
        if _holds(each) is False:
            *names, value = _followed(each.written, each.defaults)
            found |= dict.fromkeys(names, value)
    return tuple(found.items())


def decided_by(text: str, begin: int, end: int) -> tuple[When, ...]:
    """Return the conditions around something that values of arguments decide."""
    return tuple(_when(each) for each in _around(text, begin, end))


def holds(when: When, given: Mapping[str, str]) -> bool | None:
    """Tell whether a condition holds for arguments with these values, ``None`` where they do not tell."""
    value = next((given[name] for name in when.arguments if name in given), when.default).lower()
    truth = _TRUTH.get(value) if not when.value else value == when.value if value else None
    return truth if truth is None or when.holds_if else not truth


def _holds(condition: _Condition) -> bool | None:
    return holds(_when(condition), {})


def _when(condition: _Condition) -> When:
    said = _EVAL.fullmatch(condition.written.strip())
    term = _TERM.fullmatch(said[1].strip()) if said else None
    if term is None:
        *names, value = _followed(condition.written, condition.defaults)
        return When((*names,), value, "", condition.holds_if)
    holds_if = condition.holds_if ^ (term[1].count("not") % 2 == 1) ^ (term[5] == "!=")
    *names, value = _followed(f"$(arg {term[2] or term[3] or term[4]})", condition.defaults)
    return When((*names,), value, (term[6] or "").lower(), holds_if)


def _terms(condition: _Condition) -> Iterator[_Condition]:
    """Yield the conditions that have to hold, all of them, where one is put together by ``and`` and ``or``.

    Of those of which one is enough, the one that decides by the defaults. With brackets it stays whole.
    """
    said = _EVAL.fullmatch(condition.written.strip())
    if said is None or "(" in _ARGUMENT_CALL.sub("", said[1]):
        yield condition
        return
    for word, every in ((" or ", not condition.holds_if), (" and ", condition.holds_if)):
        parts = said[1].split(word)
        if len(parts) > 1:
            found = [[*_terms(condition._replace(written=f"$(eval {part.strip()})"))] for part in parts]
            yield from (each for terms in found for each in terms) if every else max(found, key=_likely)
            return
    yield condition


def _likely(terms: Iterable[_Condition]) -> int:
    """Return 2 for conditions that all hold by the defaults, 0 for some of which one does not, else 1."""
    found = {_holds(each) for each in terms}
    return 0 if False in found else 1 if None in found else 2


def _around(text: str, begin: int, end: int) -> Iterator[_Condition]:
    """Yield the conditions of what names something, and of all that is around it."""
    tags, calls = _conditions(text)
    yield from (*_of_tag(text, begin, end), *_at(_groups(text), begin)) if tags else ()
    yield from _at(_calls(text), begin) if calls else ()


@cache
def _conditions(text: str) -> tuple[bool, bool]:
    """Tell whether a file has conditions of elements, and of calls; asked only of one that names something."""
    called = "condition" in text and "condition=" in text.replace(" ", "")
    return any(matches_at(_IF, text, *_IFS)), called


def _of_tag(text: str, begin: int, end: int) -> Iterator[_Condition]:
    """Yield the conditions of the element that names a package: ``if="…"``."""
    closed = text.find(">", end, end + NEAR)
    first = max(begin - NEAR, 0)
    yield from _ifs(text[max(text.rfind("<", first, begin), first) : closed if closed >= 0 else end + NEAR], text)


def _ifs(tag: str, text: str) -> Iterator[_Condition]:
    for said in matches_at(_IF, tag, *_IFS):
        yield from _terms(_Condition(said[1] == "if", said[2] or said[3] or "", _defaults(text)))


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
    calls: list[tuple[int, list[_Condition]]] = []
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


def _of_call(text: str, begin: int) -> _Condition:
    """Return a condition of a call."""
    said = _CALLED.match(text, begin)
    if said is None:
        return _Condition(True, "", {})
    name = said[2] or _variables(text).get(said[3] or "", "")
    return _Condition(said[1] == "If", f"$(arg {name})" if name else said[4] or "", _declared(text))


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
    return _alone((said.get("name", ""), said.get("default", said.get("value", ""))) for said in _arguments(text))


def _arguments(text: str) -> Iterator[dict[str, str]]:
    """Yield the attributes of each argument that is the file's own, and not given to a file that it includes."""
    parts = (*matches_at(ARGUMENT, text, "<arg"), *matches_at(_INCLUDE, text, "<include", "</include"))
    included = False
    for match in sorted(parts, key=lambda match: match.start()):
        if not match[0].startswith("<arg"):
            included = match[0].startswith("<include") and not match[0].endswith("/>")
        elif not included:
            yield {name: one or other for name, one, other in ATTRIBUTES.findall(match[1])}


@cache
def _declared(text: str) -> dict[str, str]:
    """Return the default of each argument that a file in Python declares once."""
    return _alone((match[1], match[2] or "") for match in matches_at(_DECLARED, text, "DeclareLaunchArgument("))


@cache
def _variables(text: str) -> dict[str, str]:
    """Return the argument whose value each variable of a file in Python has."""
    return dict(_VARIABLE.findall(text))


def _alone(said: Iterable[tuple[str, str]]) -> dict[str, str]:
    found: dict[str, str] = {}
    for name, value in said:
        if (named := _REFERENCE.fullmatch(value.strip())) and named[1] == name:
            continue  # passed on: it has the value that another line gives it
        found[name] = value if found.get(name, value) == value else ""
    return found
