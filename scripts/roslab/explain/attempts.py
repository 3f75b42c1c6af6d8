"""The attempts of one step: a script of a generated image may build again, without packages that failed before."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.explain.reading import Line
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

_AGAIN = pattern(r"roslab: .{1,300}: once more\b")
"""What such a script says before it tries again: the step failed by what comes after."""
_WITHOUT = pattern(
    r"roslab: left out: (?!(?:apt|rosdep) \S{1,100}[ \t\r]*$)([\w.-]{1,100}(?: [\w.-]{1,100}){0,500})[ \t\r]*$"
)
"""The packages that the next attempt goes without."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Attempt:
    """The lines of one attempt, and the packages that were left out after it."""

    lines: tuple[Line, ...]
    without: frozenset[str] = frozenset()


def attempts(said: list[Line]) -> list[Attempt]:
    """Return the attempts of a step, the first one first."""
    found: list[Attempt] = []
    start = 0
    for index, line in enumerate(said):
        if _AGAIN.match(line.text):
            names = _WITHOUT.match(said[index + 1].text) if index + 1 < len(said) else None
            found.append(Attempt(lines=tuple(said[start:index]), without=frozenset(names[1].split() if names else ())))
            start = index + 1
    return [*found, Attempt(lines=tuple(said[start:]))]


def lacks(names: Iterable[tuple[str, str]], attempt: Attempt) -> bool:
    """Tell whether one of the names in a failure means what was left out after an attempt, or the folder of its header.

    That failure is then only what follows from why it was left out.
    """
    words = (word for _, value in names for word in value.split(", "))
    return any(not attempt.without.isdisjoint((word, word.partition("/")[0])) for word in words)
