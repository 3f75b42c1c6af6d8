"""Uses of names that a Python package has removed since: they give an upper bound for its version."""

from __future__ import annotations

import re

from roslab.evidence.python.in_comment import in_comment
from roslab.evidence.python.modules import modules
from roslab.evidence.removed_name import Removed
from roslab.knowledge.hints import Search
from roslab.knowledge.removals import newer_api, removals
from roslab.repository.checkout import Repository


def read(repository: Repository) -> tuple[Removed, ...]:
    """Return the lowest bound for each package that the code needs, with the first place that needs it.

    None for a package of which other modules use what only newer versions have: the older part, such as a baseline,
    is not what the tree is for. Nor for a line that runs beside older versions alone, and has another one beside it.
    """
    found: dict[str, tuple[int, Removed]] = {}
    newer: set[str] = set()
    wanted = Search(removals(), words=True)
    for module in modules(repository):
        text = module.text
        possible = wanted.possible(text, module.words)
        newer |= {row.package for row in possible if (api := newer_api().get(row.package)) and api.search(text)}
        for row in possible:
            if row.package in found and found[row.package][0] <= row.rank:
                continue  # only a lower bound of the same package would matter
            match = next((m for m in row.pattern.finditer(text) if _counts(text, m)), None)
            if match is None:
                continue
            line = text.count("\n", 0, match.start()) + 1
            use = Removed(bound=row.bound, what=row.what, file=module.file.path, line=line)
            found[row.package] = (row.rank, use)
    kept = (use for package, (_, use) in found.items() if package not in newer)
    return tuple(sorted(kept, key=lambda use: use.bound.written))


def _counts(text: str, match: re.Match[str]) -> bool:
    """Tell whether a use stands in the code, for every version of the library."""
    start = match.start()
    if in_comment(text, start):
        return False
    from roslab.evidence.python.branches import in_docstring, of_some_versions  # noqa: PLC0415 - it imports Python's own parser

    return not (in_docstring(text, start) or of_some_versions(text, match.end()))
