"""What is always read of a robot description: what stands outside of macros and conditions, and macros that it calls.

https://github.com/ros/xacro/wiki, 2026-11-27.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import cache
from typing import NamedTuple

from roslab.values.pattern import pattern

MOST = 60
"""Most files of one description that are read."""
_PART = pattern(
    r"<(/?)xacro:(if|unless|macro)\b(?:[^<>]{0,900}?\sname\s?=\s?[\"'](?:xacro:)?([\w.-]{1,80})[\"'])?",
)
"""Where a part of a description that is not always read begins or ends, with the name of a macro."""
_CALL = pattern(r"<xacro:([\w.-]{1,80})")
_UNDECIDED = "?"
"""The owner of what a condition holds; no macro has such a name."""


class _Part(NamedTuple):
    macro: str
    """``""`` outside of macros."""
    begin: int
    end: int


def always_read(
    path: str, text_of: Callable[[str], str | None], included: Callable[[str], Iterable[str]]
) -> Iterator[tuple[str, str]]:
    """Yield the path and the text of what is always read of a description and of those that it includes.

    The text has the lines of its file, empty where they are not of this part. A macro is read once, where it is called
    outside of all macros or by another one that is read; what a condition holds is not. ``text_of``: the text of a file
    without its comments, ``None`` where it is no description; ``included``: the files that a text names.
    """
    macros: dict[str, tuple[str, str]] = {}
    files, read, called = {path}, set[str](), set[str]()
    waiting = [*_opened(path, text_of, macros)]
    while waiting:
        file, part = waiting.pop(0)
        yield file, part
        called.update(_CALL.findall(part))
        for name in included(part):
            if name not in files and len(files) < MOST:
                files.add(name)
                waiting += _opened(name, text_of, macros)
        if not waiting:
            ready = sorted(called & macros.keys() - read)
            read.update(ready)
            waiting += [(macros[name][0], _of_macro(macros[name][1], name)) for name in ready]


def _opened(
    path: str, text_of: Callable[[str], str | None], macros: dict[str, tuple[str, str]]
) -> Iterator[tuple[str, str]]:
    """Yield what stands outside of the macros of a file, and keep where each macro is."""
    if (text := text_of(path)) is not None:
        for part in _parts(text):
            if part.macro not in {"", _UNDECIDED}:
                macros.setdefault(part.macro, (path, text))
        yield path, _of_macro(text, "")


def _of_macro(text: str, macro: str) -> str:
    """Return what stands in a macro itself, ``""`` for outside of all; the lines stay."""
    return "".join(
        text[part.begin : part.end] if part.macro == macro else "\n" * text.count("\n", part.begin, part.end)
        for part in _parts(text)
    )


@cache
def _parts(text: str) -> tuple[_Part, ...]:
    found: list[_Part] = []
    within: list[str] = []
    begin = 0
    for match in _PART.finditer(text):
        found.append(_Part(_owner(within), begin, match.start()))
        begin = match.start()
        if not match[1]:
            within.append((match[3] or _UNDECIDED) if match[2] == "macro" else _UNDECIDED)
        elif within:
            within.pop()
    return (*found, _Part(_owner(within), begin, len(text)))


def _owner(within: list[str]) -> str:
    return _UNDECIDED if _UNDECIDED in within else within[-1] if within else ""
