"""What a program, or a module of the tree that it imports, imports at its top: where that is missing, it stops."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Mention
from roslab.evidence.program import Program
from roslab.evidence.python.imports import modules_of, statements
from roslab.evidence.python.modules import Module, modules, run_by_pages
from roslab.evidence.python.through_modules import Modules
from roslab.knowledge.frameworks import imports
from roslab.repository.checkout import Repository


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
    where = {module.file.path: tuple(_imported(module, unknown)) for module in found}
    if not any(where.values()):
        return
    tree = Modules(found)
    starts = run_by_pages(mentions) | {each.file for each in programs if not places.test(each.file)}
    for start in sorted(starts & tree.by_file.keys()):
        folder = tree.by_file[start].file.folder
        seen: set[str] = set()
        for file in (start, *sorted(tree.reached((start,), folder) - {start})):
            for name, line in where[file]:
                if name not in seen:
                    seen.add(name)
                    yield Mention(
                        topic="reached",
                        value=name,
                        source="code",
                        file=file,
                        line=line,
                        text=f"import {name}",
                        inside=start,
                    )


def _imported(module: Module, names: Collection[str]) -> Iterator[tuple[str, int]]:
    """Yield those of the names that a module imports under no condition, each with its line."""
    if not any(name in module.text for name in names):
        return
    for match in statements(module.text):
        for name in modules_of(match) if not match["indent"] else ():
            if name in names:
                yield name, module.text.count("\n", 0, match.start()) + 1
