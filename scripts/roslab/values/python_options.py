"""Python's own options, which stand before the program in a call of Python."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.values.pattern import pattern

_OPTION = pattern(r"-(?=.)[BEIOSbdiqsuv]*(?:([mWX])(.*))?")
"""One or more letters, of which the last may have a value, in the same word or the next: ``-um``, ``-Wignore``."""


def program_of_python(words: Sequence[str]) -> tuple[tuple[str, ...], int]:
    """Return the words that name the program in a call of Python, and where its arguments begin.

    These are ``-m`` and the module, else the file; none where the call names no program.
    https://docs.python.org/3/using/cmdline.html, read 2026-11-25
    """
    place = 1
    while place < len(words) and (option := _OPTION.fullmatch(words[place])):
        if option[1] == "m":
            rest = place + (1 if option[2] else 2)
            return ("-m", *((option[2],) if option[2] else words[place + 1 : rest])), rest
        place += 2 if option[1] and not option[2] else 1
    return tuple(words[place : place + 1]), place + 1
