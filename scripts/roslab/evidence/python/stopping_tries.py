"""Lines in a ``try`` at the top of a module that nothing goes on without: where one of them fails, all is stopped."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from roslab.evidence.lex.indents import depth
from roslab.values.pattern import pattern

TRY = pattern(r"try[ \t]*:[ \t]*(?:#.*)?$")
EXCEPT = pattern(r"except\b(?P<what>[^:#]*):[ \t]*(?P<rest>[^#]*)")
_MISSING = pattern(r"[ \t(]*$|.*\b(?:ImportError|ModuleNotFoundError|Exception)\b")
STOPS = pattern(r"raise\b|(?:sys\.|os\._)?exit[ \t]*\(|quit[ \t]*\(|os\.abort[ \t]*\(")
_IMPORTS = pattern(r"(?:import|from)[ \t]|.*\b(?:__import__|import_module)[ \t]*\(")
Line = tuple[int, str]
"""Where it begins, and itself."""


def starts(text: str) -> frozenset[int]:
    """Return where these lines begin, of those that stand under no further condition.

    Each ``except`` for what is missing ends in ``raise`` or ``exit``, and imports nothing in place of it.
    """
    if "\nexcept" not in text or not ("\ntry" in text or text.startswith("try")):
        return frozenset()
    parts = list(_parts(text))
    found: set[int] = set()
    for index, ((_, head), body) in enumerate(parts):
        if not TRY.match(head) or not body:
            continue
        handlers = []
        for number in range(index + 1, len(parts)):
            (_, behind), below = parts[number]
            caught = EXCEPT.match(behind)
            if not caught:
                break
            if _MISSING.match(caught["what"]):
                handlers.append([*([(0, caught["rest"])] if caught["rest"].strip() else ()), *below])
        if handlers and all(map(_stops, handlers)):
            least = depth(body[0][1])
            found.update(start for start, line in body if depth(line) == least)
    return frozenset(found)


def _parts(text: str) -> Iterator[tuple[Line, Sequence[Line]]]:
    """Yield each statement at the left margin, and the lines below it; no comments and no empty lines."""
    head: Line | None = None
    below: list[Line] = []
    start = 0
    for line in text.split("\n"):
        said = line.strip()
        if said and not said.startswith("#"):
            if line[0] in " \t":
                below.append((start, line))
            else:
                if head:
                    yield head, below
                head, below = (start, said), []
        start += len(line) + 1
    if head:
        yield head, below


def _stops(handler: Sequence[Line]) -> bool:
    if not handler or any(_IMPORTS.match(line.strip()) for _, line in handler):
        return False
    least = depth(handler[0][1])
    last = [line for _, line in handler if depth(line) == least]
    return any(STOPS.match(line.strip()) for line in last)
