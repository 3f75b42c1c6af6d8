"""Uses of names that a Python package has removed since: they give an upper bound for its version."""

from __future__ import annotations

from roslab.evidence.facts import Removed
from roslab.evidence.python.modules import modules
from roslab.knowledge.hints import Search
from roslab.knowledge.removals import removals
from roslab.repository.checkout import Repository


def read(repository: Repository) -> tuple[Removed, ...]:
    """Return the lowest bound for each package that the code needs, with the first place that needs it."""
    found: dict[str, tuple[int, Removed]] = {}
    wanted = Search(removals(), words=True)
    for module in modules(repository):
        text = module.text
        for row in wanted.possible(text, module.words):
            if row.package in found and found[row.package][0] <= row.rank:
                continue  # only a lower bound of the same package would matter
            match = next((m for m in row.pattern.finditer(text) if not _comment(text, m.start())), None)
            if match is None:
                continue
            line = text.count("\n", 0, match.start()) + 1
            use = Removed(bound=row.bound, what=row.what, file=module.file.path, line=line)
            found[row.package] = (row.rank, use)
    return tuple(sorted((use for _, use in found.values()), key=lambda use: use.bound.written))


def _comment(text: str, position: int) -> bool:
    """Tell whether a position lies in a line that is a comment."""
    return text[text.rfind("\n", 0, position) + 1 : position + 1].lstrip().startswith("#")
