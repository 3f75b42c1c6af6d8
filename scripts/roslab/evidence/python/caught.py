"""Modules without which the code goes on: wherever it imports them, a ``try`` catches what their import raises."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.indents import depth
from roslab.evidence.python.modules import Module, modules
from roslab.evidence.python.stopping_tries import EXCEPT, STOPS, TRY
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_RAISED = pattern(r"[ \t(]*$|.*\b(?:ImportError|ModuleNotFoundError|Exception|BaseException|OSError|RuntimeError)\b")
"""What a module that is not there raises, or one that does not find its device or its library."""


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return each such module (``value``) at the first of its imports; tests and samples do not count."""
    found: dict[str, Mention] = {}
    needed: set[str] = set()
    for module in modules(repository):
        if places.aside(module.file.path):
            continue
        for match, line, caught in _imports(module):
            tops = _tops(match["module"] or match["plain"])
            if not caught:
                needed.update(tops)
                continue
            for top in tops:
                said = Mention(
                    topic="caught_import", value=top, source="code", file=module.file.path, line=line, text=top
                )
                found.setdefault(top, said)
    return tuple(each for top, each in found.items() if top not in needed)


def _tops(named: str) -> list[str]:
    return [each.split()[0].partition(".")[0] for each in named.split(",") if each.strip()]


def _imports(module: Module) -> Iterator[tuple[re.Match[str], int, bool]]:
    """Yield each statement that imports, its line, and whether it stands in a ``try`` whose handlers go on."""
    tried = "except" in module.text and any(match["indent"] for match in module.statements)
    lines = module.text.split("\n") if tried else ()
    above = _above(lines)
    goes_on: dict[int, bool] = {}
    line, counted = 1, 0
    for match in module.statements:
        line += module.text.count("\n", counted, match.start())
        counted = match.start()
        opens = above.get(line - 1) if match["indent"] else None
        if opens is not None and opens not in goes_on:
            goes_on[opens] = bool(TRY.match(lines[opens].strip())) and _goes_on(lines, opens)
        yield match, line, opens is not None and goes_on[opens]


def _above(lines: Sequence[str]) -> dict[int, int]:
    """Return for each line the nearest one above it that is less indented, by their indices; comments are none."""
    found: dict[int, int] = {}
    around: list[tuple[int, int]] = []
    for index, line in enumerate(lines):
        if line.strip() and not line.lstrip().startswith("#"):
            deep = depth(line)
            while around and around[-1][0] >= deep:
                around.pop()
            if around:
                found[index] = around[-1][1]
            around.append((deep, index))
    return found


def _goes_on(lines: Sequence[str], start: int) -> bool:
    """Tell whether a handler of the ``try`` at an index catches what an import raises, and none of them stops."""
    least, handlers, stops = depth(lines[start]), 0, False
    for line in lines[start + 1 :]:
        said = line.strip()
        if not said or said.startswith("#"):
            continue
        if depth(line) < least or (depth(line) == least and not said.startswith(("except", "else", "finally"))):
            break
        if depth(line) == least:
            handler = EXCEPT.match(said)
            handlers += bool(handler and _RAISED.match(handler["what"]))
            said = handler["rest"] if handler else ""
        stops = stops or (handlers > 0 and any(STOPS.match(each.strip()) for each in said.split(";")))
    return handlers > 0 and not stops
