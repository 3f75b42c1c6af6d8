"""What is always read of a robot description: what stands outside of macros and conditions, and macros that it calls.

What a condition holds is read where that is known to be true. https://github.com/ros/xacro/wiki, 2026-11-27.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from functools import cache
from typing import NamedTuple

from roslab.evidence.lex.attributes import attributes
from roslab.evidence.ros.xacro_values import Condition, holds, of_call, with_declared
from roslab.values.pattern import pattern

MOST = 60
"""Most files of one description that are read."""
MOST_CALLS = 400
"""Most macros of one that are read, one with other values counts again."""
_PART = pattern(r"<(/?)xacro:(if|unless|macro)\b([^<>]{0,900})>")
"""Where a part of a description that is not always read begins or ends."""
_CALL = pattern(r"<xacro:([\w.-]{1,80})((?:\s[^<>]{0,900})?)")


class _Part(NamedTuple):
    macro: str
    """``""`` outside of macros, ``"?"`` for a macro inside of a condition, which may not be there."""
    conditions: tuple[Condition, ...]
    begin: int
    end: int


class _Macro(NamedTuple):
    path: str
    text: str
    name: str
    parameters: str


_NOWHERE = "?"
_Frame = tuple[str, tuple[Condition, ...]]


def always_read(
    path: str,
    text_of: Callable[[str], str | None],
    included: Callable[[str], Iterable[str]],
    given: Collection[str] = (),
) -> Iterator[tuple[str, str]]:
    """Yield the path and the text of what is always read of a description and of those that it includes.

    The text has the lines of its file, empty where they are not of this part. A macro is read where it is called
    outside of all macros or by another one that is read: once, unless what it is called with decides its conditions.
    ``text_of``: the text of a file without its comments, ``None`` where it is no description; ``included``: the files
    that a text names; ``given``: the arguments that launch files set.
    """
    yield from _Reading(text_of, included, given).all(path)


class _Reading:
    def __init__(
        self,
        text_of: Callable[[str], str | None],
        included: Callable[[str], Iterable[str]],
        given: Collection[str],
    ) -> None:
        self._text_of, self._included, self._given = text_of, included, given
        self._values: dict[str, str | None] = {}
        self._macros: dict[str, _Macro] = {}
        self._files: set[str] = set()
        self._read: set[tuple[str, frozenset[tuple[str, str]]]] = set()
        self._calls: list[tuple[str, Mapping[str, str], Mapping[str, str]]] = []

    def all(self, path: str) -> Iterator[tuple[str, str]]:
        """Yield what is read of a file, of those that it includes, and of the macros that these call."""
        waiting = [path]
        while waiting or self._calls:
            if waiting:
                name = waiting.pop(0)
                opened = self._opened(name)
            else:
                name, opened = self._called()
            if opened is not None:
                yield name, opened
                waiting += self._new(opened)

    def _new(self, text: str) -> Iterator[str]:
        for name in self._included(text):
            if name not in self._files and len(self._files) < MOST:
                self._files.add(name)
                yield name

    def _opened(self, path: str) -> str | None:
        """Return what is read of a file outside of its macros, and keep where each of these is."""
        self._files.add(path)
        if (text := self._text_of(path)) is None:
            return None
        parts, macros = _parts(text)
        for name, parameters in macros.items():
            self._macros.setdefault(name, _Macro(path, text, name, parameters))
        sure = [part for part in parts if not (part.macro or part.conditions)]
        with_declared(self._values, "".join(text[part.begin : part.end] for part in sure), self._given)
        known = self._known()
        found = _chosen(text, "", known)
        self._note(found, known)
        return found

    def _called(self) -> tuple[str, str | None]:
        """Return the file and what is read of a macro that is called, ``None`` where that was read or is nowhere."""
        name, call, values = self._calls.pop(0)
        if (macro := self._macros.get(name)) is None or len(self._read) >= MOST_CALLS:
            return "", None
        inside = of_call(macro.parameters, call, {**self._known(), **values})
        decides = any(part.macro == name and part.conditions for part in _parts(macro.text)[0])
        key = name, frozenset(inside.items() if decides else ())
        if key in self._read:
            return "", None
        self._read.add(key)
        found = _chosen(macro.text, name, inside)
        self._note(found, inside)
        return macro.path, found

    def _note(self, text: str, values: Mapping[str, str]) -> None:
        self._calls += [(match[1], attributes(match[2]), values) for match in _CALL.finditer(text)]

    def _known(self) -> dict[str, str]:
        return {name: value for name, value in self._values.items() if value is not None}


def _chosen(text: str, macro: str, values: Mapping[str, str]) -> str:
    """Return what is read in a macro itself, ``""`` for outside of all; the lines stay."""
    return "".join(
        text[part.begin : part.end]
        if part.macro == macro and holds(part.conditions, values)
        else "\n" * text.count("\n", part.begin, part.end)
        for part in _parts(text)[0]
    )


@cache
def _parts(text: str) -> tuple[tuple[_Part, ...], dict[str, str]]:
    """Return the parts of a description, and its macros with their parameters."""
    found: list[_Part] = []
    macros: dict[str, str] = {}
    within: list[_Frame] = [("", ())]
    begin = 0
    for match in _PART.finditer(text):
        found.append(_Part(*within[-1], begin, match.start()))
        begin = match.start()
        if match[1]:
            within = within[:-1] or [("", ())]
        elif not match[3].rstrip().endswith("/"):
            within.append(_inner(match[2], attributes(match[3]), within[-1], macros))
    return (*found, _Part(*within[-1], begin, len(text))), macros


def _inner(element: str, said: Mapping[str, str], outer: _Frame, macros: dict[str, str]) -> _Frame:
    """Return the macro and the conditions in an element, and note a macro."""
    macro, conditions = outer
    if element != "macro":
        return macro, (*conditions, Condition(element == "if", said.get("value", "$")))
    name = said.get("name", "").removeprefix("xacro:")
    if macro or conditions or not name:
        return _NOWHERE, ()
    macros.setdefault(name, said.get("params", ""))
    return name, ()
