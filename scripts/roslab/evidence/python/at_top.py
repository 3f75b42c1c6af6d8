"""What a program that a page runs imports at its top: without it, it does not start."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.python.imports import modules_of, statements
from roslab.evidence.python.modules import modules, run_by_pages
from roslab.repository.checkout import Repository


def read(repository: Repository, mentions: Iterable[Mention]) -> Iterator[Mention]:
    """Yield the modules that each of these programs imports under no condition, with the place of the first import."""
    run = run_by_pages(mentions)
    for module in modules(repository) if run else ():
        if module.file.path not in run:
            continue
        found: dict[str, int] = {}
        for match in statements(module.text):
            for name in modules_of(match) if not match["indent"] else ():
                found.setdefault(name, module.text.count("\n", 0, match.start()) + 1)
        for name, line in found.items():
            yield Mention(
                topic="at_top", value=name, source="code", file=module.file.path, line=line, text=f"import {name}"
            )
