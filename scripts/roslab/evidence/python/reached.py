"""What a program, or a module of the tree that it imports, imports at its top: where that is missing, it stops."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from itertools import islice

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Mention
from roslab.evidence.program import Program
from roslab.evidence.python.import_graph import ImportGraph
from roslab.evidence.python.imports import modules_of
from roslab.evidence.python.modules import Module, modules, run_by_pages
from roslab.evidence.python.through_modules import of_tree
from roslab.knowledge.frameworks import imports
from roslab.repository.checkout import Repository

MOST = 20_000
"""Most mentions, those of what pages run first."""


def read(
    repository: Repository, code: Iterable[Dependency], programs: Iterable[Program], mentions: Iterable[Mention]
) -> Iterator[Mention]:
    """Yield for each program the modules of no table that it cannot start without, each with its first place.

    Programs (``inside``) are what a page runs and what has a ``__main__`` guard. ``code``: what the tree imports from
    outside. Only imports that stand under no condition count, on the way there as well.
    """
    unknown = {each.name for each in code if each.namespace == "import" and each.strength == "used"} - imports().keys()
    if not unknown:
        return
    found = modules(repository)
    where = {module.file.path: imported(module, unknown) for module in found}
    if not any(where.values()):
        return
    graph, run = of_tree(repository).graph, run_by_pages(mentions)
    importing: dict[str, int] = {}
    for file, names in where.items():
        for name in names:
            importing[name] = importing.get(name, 0) | graph.bit(file)
    starts = (run | {each.file for each in programs if not places.test(each.file)}) & where.keys()
    said: dict[str, tuple[Mention, ...]] = {}
    left = MOST
    for start in sorted(starts, key=lambda file: (file not in run, file)):
        said[start] = tuple(islice(_reached(start, graph, importing, where), left))
        left -= len(said[start])
    for start in sorted(said):
        yield from said[start]


def _reached(
    start: str, graph: ImportGraph, importing: Mapping[str, int], where: Mapping[str, Mapping[str, int]]
) -> Iterator[Mention]:
    """Yield the names that a program reaches, each in the first file that imports it: its own, then by their paths."""
    files = graph.reach(start) or 0
    there = {name: graph.first(files & those) for name, those in importing.items() if files & those}
    there |= dict.fromkeys(where[start], start)
    for file in sorted({*there.values()}, key=lambda file: (file != start, file)):
        for name, line in where[file].items():
            if there[name] == file:
                yield Mention(
                    topic="reached",
                    value=name,
                    source="code",
                    file=file,
                    line=line,
                    text=f"import {name}",
                    inside=start,
                )


def imported(module: Module, names: Collection[str]) -> dict[str, int]:
    """Return those of the names that a module imports under no condition, each with its first line."""
    found: dict[str, int] = {}
    for match in module.statements:
        for name in modules_of(match) if not match["indent"] else ():
            if name in names and name not in found:
                found[name] = module.text.count("\n", 0, match.start()) + 1
    return found
