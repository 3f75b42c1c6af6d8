"""Patterns that are compiled when they are first used: of the several hundred, one repository needs a few.

They are the program's own, whose compiled form is kept for the next start; what is made of a repository's words is
compiled by ``re`` and forgotten.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any, cast

from roslab.values.kept_patterns import compiled


class _Lazy:
    """Stands for a compiled pattern, whose methods and attributes it has."""

    def __init__(self, source: str, flags: int) -> None:
        self._given = (source, flags)

    def __getattr__(self, name: str) -> Any:
        """Compile the pattern, and keep the method, so that the next use of it does not come here."""
        if name == "pattern":
            return self._given[0]
        found = getattr(compiled(*self._given), name)
        setattr(self, name, found)
        return found


def pattern(source: str, flags: int = 0) -> re.Pattern[str]:
    """Return what ``re.compile`` does, made at its first use.

    ``re``'s own functions do not take it: use its methods. A source that is no pattern raises ``re.error`` at that
    first use; a test compiles every one.
    """
    return cast("re.Pattern[str]", _Lazy(source, flags))


def one_of(sources: Iterable[str]) -> re.Pattern[str]:
    """Return a pattern that matches where one of these matches up to the end of a text."""
    return pattern("(?:" + "|".join(f"(?:{source})" for source in sources) + r")\Z")


def named_by(globs: Iterable[str]) -> re.Pattern[str]:
    """Return a pattern that matches a name as one of these is written, in which ``*`` alone stands for anything.

    Where many names are asked for, ``fnmatch`` would compile what it has forgotten since the last one.
    """
    return one_of(re.escape(each).replace(r"\*", ".*") for each in globs)


@contextmanager
def postponed() -> Iterator[None]:
    """Let the patterns that a library makes while it is imported wait for their first use, too.

    For libraries that call methods of their patterns and hand them to nobody, as a look at their code tells.
    """
    at_once = re.compile
    re.compile = pattern  # type: ignore[assignment]
    try:
        yield
    finally:
        re.compile = at_once
