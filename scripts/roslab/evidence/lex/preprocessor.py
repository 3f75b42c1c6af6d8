"""The conditions of C's preprocessor around a place in a file."""

from __future__ import annotations

import re
from collections.abc import Callable

from roslab.evidence.lex.truth import Truth, macros_hold
from roslab.values.pattern import pattern

_DIRECTIVE = pattern(r"^[ \t]*#[ \t]*(if|ifdef|ifndef|elif|else|endif)\b[ \t]*([^\n]*)", re.MULTILINE)


def reached(text: str, position: int, defined: Callable[[str], bool]) -> Truth:
    """Tell whether a place is compiled for ARM of 64 bits; the guard of a header around itself is no condition.

    ``defined`` tells of a name, that neither compiler nor system has, whether the build or the file defines it.
    """
    open_: list[tuple[Truth, ...]] = []
    for match in _DIRECTIVE.finditer(text, 0, position):
        kind, written = match[1], match[2].strip()
        if kind == "endif":
            del open_[-1:]
        elif kind in {"elif", "else"}:
            truth = True if kind == "else" else macros_hold(written, defined)
            open_[-1:] = [(*open_[-1], truth)] if open_ else []
        elif kind == "ifndef" and re.match(rf"\s*#\s*define\s+{re.escape(written)}\b", text[match.end() :][:200]):
            open_.append((True,))
        else:
            sign = {"ifdef": "", "ifndef": "!"}.get(kind)
            written = written if sign is None else f"{sign}defined({written.split()[0] if written else ''})"
            open_.append((macros_hold(written, defined),))
    found = {_branch(each) for each in open_}
    return False if False in found else None if None in found else True


def _branch(each: tuple[Truth, ...]) -> Truth:
    """Tell whether the last of several branches is the one that is compiled."""
    *before, last = each
    if True in before or last is False:
        return False
    return None if None in before else last
