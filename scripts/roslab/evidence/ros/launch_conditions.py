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
from roslab.evidence.ros import launch_expressions as expressions
from roslab.evidence.ros.argument_defaults import REFERENCE, declared, defaults, variables
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
            when = _when(each)
            found |= dict.fromkeys(when.arguments, when.default)
    return tuple(found.items())


def decided_by(text: str, begin: int, end: int) -> tuple[When, ...]:
    """Return the conditions around something that values of arguments decide."""
    return tuple(_when(each) for each in _around(text, begin, end))


def holds(when: When, given: Mapping[str, str]) -> bool | None:
    """Tell whether a condition holds for arguments with these values, ``None`` where they do not tell."""
    if when.expression:
        truth = expressions.truth(expressions.result(when.expression, _Values(given, dict(when.defaults)).of))
        return truth if truth is None or when.holds_if else not truth
    value = next((given[name] for name in when.arguments if name in given), when.default).lower()
    truth = _TRUTH.get(value) if not when.value else value == when.value if value else None
    return truth if truth is None or when.holds_if else not truth


def _holds(condition: _Condition) -> bool | None:
    return holds(_when(condition), {})


def _when(condition: _Condition) -> When:
    said = _EVAL.fullmatch(condition.written.strip())
    term = _TERM.fullmatch(said[1].strip()) if said else None
    if by_expression := _of_expression(condition, plain=term is not None):
        return by_expression
    if term is None:
        *names, value = _followed(condition.written, condition.defaults)
        return When((*names,), value, "", condition.holds_if)
    holds_if = condition.holds_if ^ (term[1].count("not") % 2 == 1) ^ (term[5] == "!=")
    *names, value = _followed(f"$(arg {term[2] or term[3] or term[4]})", condition.defaults)
    return When((*names,), value, (term[6] or "").lower(), holds_if)


def _of_expression(condition: _Condition, *, plain: bool) -> When | None:
    """Return a condition that an expression decides, itself or by the default of an argument; ``None`` for others.

    ``plain``: it asks for one argument alone, whose default decides.
    """
    named = REFERENCE.fullmatch(condition.written.strip())
    text = f"arg({named[1]!r})" if named else expressions.expression(condition.written)
    asked = [*expressions.names(text)] if text else []
    defaults: dict[str, str] = {}
    whole = not (named or plain)
    for name in asked:
        if name in defaults or name not in condition.defaults or len(defaults) >= _DEEPEST:
            continue
        defaults[name] = written = condition.defaults[name]
        inner = expressions.expression(written)
        follows = REFERENCE.fullmatch(written.strip())
        asked += expressions.names(inner) if inner else (follows[1],) if follows else ()
        whole = whole or bool(inner)
    if not (text and whole):
        return None
    alone = tuple(dict.fromkeys(asked)) if len({*asked}) == 1 else ()
    return When(alone, defaults.get("".join(alone), ""), "", condition.holds_if, text, tuple(defaults.items()))


class _Values:
    """The values of arguments that are ``given`` or have ``defaults``."""

    def __init__(self, given: Mapping[str, str], defaults: Mapping[str, str]) -> None:
        self._defaults = defaults
        self._known: dict[str, str | None] = dict(given)

    def of(self, name: str) -> str | None:
        """Return the value of an argument, ``None`` where nothing tells it."""
        if name not in self._known:
            self._known[name] = None  # one that has its value from itself has none
            self._known[name] = self._default(self._defaults.get(name))
        return self._known[name]

    def _default(self, written: str | None) -> str | None:
        if written is None:
            return None
        if named := REFERENCE.fullmatch(written.strip()):
            return self.of(named[1])
        if text := expressions.expression(written):
            return expressions.result(text, self.of)
        return None if "$(" in written else written


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
        yield from _terms(_Condition(said[1] == "if", said[2] or said[3] or "", defaults(text)))


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
    name = said[2] or variables(text).get(said[3] or "", "")
    return _Condition(said[1] == "If", f"$(arg {name})" if name else said[4] or "", declared(text))


def _followed(written: str, defaults: Mapping[str, str]) -> tuple[str, ...]:
    """Return the arguments that give a value, and it."""
    names: list[str] = []
    while len(names) < _MOST and (named := REFERENCE.fullmatch(written.strip())):
        names.append(named[1])
        written = defaults.get(named[1], "")
    return (*names, written.strip().lower())
