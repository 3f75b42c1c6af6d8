"""Includes that are compiled only where CMake found the library that they are of: ``#if XTENSOR_FOUND``."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_DIRECTIVE = pattern(r"^[ \t]*#[ \t]*(if|ifdef|ifndef|elif|else|endif)\b([^\n]*)", re.MULTILINE)
_NUMBER = pattern(r"\d+$")
_NEGATED = pattern(r"!\s*(?:defined\b)?[\s(]*$")


def where_found(text: str, position: int, header: str) -> bool:
    """Tell whether a header at a position of a file stands under a condition that its library is there, or is used.

    The name of the library is that of the header's folder, or of the header itself where it has none.
    """
    name = header.partition("/")[0].partition(".")[0].upper().replace("-", "_")
    asked = {
        f"{prefix}{each}" for each in (name, _NUMBER.sub("", name)) for prefix in ("HAVE_", "WITH_", "USE_", "HAS_")
    }
    asked |= {f"{each}_FOUND" for each in (name, _NUMBER.sub("", name))}
    above = text[:position].upper()
    if not any(each in above for each in asked):
        return False
    open_: list[bool] = []
    for match in _DIRECTIVE.finditer(text, 0, position):
        kind = match[1]
        if kind == "endif":
            del open_[-1:]
        elif kind == "ifndef":
            open_.append(False)
        elif kind.startswith("if"):
            open_.append(_asks(match[2], asked))
        elif open_:
            open_[-1] = kind == "elif" and _asks(match[2], asked)
    return any(open_)


def _asks(condition: str, names: set[str]) -> bool:
    """Tell whether a condition asks for one of the names, and not for that it is not there."""
    for word in re.finditer(r"\w+", condition):
        if word[0].upper() in names and not _NEGATED.search(condition[: word.start()]):
            return True
    return False
