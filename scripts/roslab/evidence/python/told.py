"""Packages that the code itself tells its user to install: ``raise ImportError("Run `pip install gdown`")``."""

from __future__ import annotations

from roslab.evidence.lex.lines import matches_at
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern

_SIGN = "pip install "
_TOLD = pattern(r"pip install (?:(?:-U|--upgrade|--user) )?([A-Za-z][\w-]*(?:\.\w+)*)((?:[=~!<>]=|[<>])[\d.]+(?<!\.))?")
_QUOTES = ("'", '"')


def told(text: str) -> dict[str, str]:
    """Return the packages that strings of a module tell to install, by their names, each with its version.

    Such a string begins on the line itself: a docstring and a comment explain the file to those who read it.
    """
    if _SIGN not in text:
        return {}
    found: dict[str, str] = {}
    for match in matches_at(_TOLD, text, _SIGN):
        if in_string(text[text.rfind("\n", 0, match.start()) + 1 : match.start()]):
            found.setdefault(canonicalize_name(match[1]), match[2] or "")
    return found


def in_string(before: str) -> bool:
    """Tell whether a string that is no docstring has begun in the part of a line before something."""
    return any(quote in before for quote in _QUOTES) and '"""' not in before and not before.lstrip().startswith("#")
