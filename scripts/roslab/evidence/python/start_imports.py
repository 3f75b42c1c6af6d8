"""What the programs that pages start cannot do without: what they, or modules of the tree that they import, import."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import islice

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Mention
from roslab.evidence.program import Program
from roslab.evidence.python.compiled_modules import whole_names
from roslab.evidence.python.extension_imports import needed
from roslab.evidence.python.import_graph import ImportGraph
from roslab.evidence.python.modules import run_by_pages
from roslab.evidence.python.reached import imported
from roslab.evidence.python.through_modules import of_tree
from roslab.repository.checkout import Repository

MOST_PROGRAMS = 20
"""Most programs that are followed: those of pages first, then of their scripts, then the nearest to the root."""
MOST = 80
"""Most modules of one program."""


def read(
    repository: Repository, code: Iterable[Dependency], programs: Iterable[Program], mentions: Iterable[Mention]
) -> Iterator[Mention]:
    """Yield for each program (``inside``) the modules from outside that it reaches under no condition.

    After them come those that a setup.py of the tree compiles.
    """
    names = {each.name for each in code if each.namespace == "import" and each.strength == "used"}
    mentions = tuple(mentions)
    scripts = {file for said in mentions if said.topic == "runs" for file in said.files if file.endswith(".py")}
    others = {each.file for each in programs if not places.test(each.file)}
    compiled = whole_names(repository)
    found = of_tree(repository) if names or compiled else None
    if found is None:
        return
    starts = [file for group in (run_by_pages(mentions), scripts, others) for file in _nearest(group)]
    where: dict[str, dict[str, int]] = {}
    for start in [file for file in dict.fromkeys(starts) if file in found.by_file][:MOST_PROGRAMS]:
        told: dict[str, Mention] = {}
        extensions: dict[str, Mention] = {}
        for file in _files(found.graph, start):
            if file not in where:
                where[file] = imported(found.by_file[file], names)
            for name, line in where[file].items():
                told.setdefault(name, _mention(name, file, line, start))
            for each in needed(found, file, compiled, start):
                extensions.setdefault(each.value, each)
        yield from islice(told.values(), MOST)
        yield from extensions.values()


def _nearest(files: Iterable[str]) -> list[str]:
    return sorted(files, key=lambda file: (file.count("/"), file))


def _files(graph: ImportGraph, start: str) -> Iterator[str]:
    """Yield the files that a program runs, its own first."""
    yield start
    left = (graph.reach(start) or 0) & ~graph.bit(start)
    while left:
        yield graph.first(left)
        left &= left - 1


def _mention(name: str, file: str, line: int, start: str) -> Mention:
    text = f"import {name}"
    return Mention(topic="start_import", value=name, source="code", file=file, line=line, text=text, inside=start)
