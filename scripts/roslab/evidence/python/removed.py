"""Uses of names that a Python package has since removed: they say how old that package must be."""

from __future__ import annotations

from roslab.evidence.facts import Dependency
from roslab.evidence.python.imports import MAX_READ, modules
from roslab.knowledge.removals import removals
from roslab.repository.checkout import Repository


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return the lowest bound of each package that the tree's code asks for, at the first place that does.

    ``name`` is the bound as a requirement (``matplotlib<3.5``), ``role`` what was removed.
    """
    found: dict[str, tuple[int, Dependency]] = {}
    for file in modules(repository):
        text = repository.read(file, limit=MAX_READ)
        for rank, row in enumerate(removals()):
            if row.package in found and found[row.package][0] <= rank:
                continue  # only a lower bound of the same package could still say more
            if row.hint not in text or not (match := row.pattern.search(text)):
                continue
            line = text.count("\n", 0, match.start()) + 1
            use = Dependency(namespace="pip", name=row.bound, strength="used", file=file.path, line=line, role=row.what)
            found[row.package] = (rank, use)
    return tuple(sorted((use for _, use in found.values()), key=lambda use: use.name))
