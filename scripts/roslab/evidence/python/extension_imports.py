"""Modules that a setup.py of the tree compiles, where Python imports them."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.python.modules import Module
from roslab.evidence.python.through_modules import imported_names


def needed(module: Module, file: str, names: Collection[str], start: str) -> Iterator[Mention]:
    """Yield each of the whole names that a module imports at its top, for the program that it is imported by."""
    there: list[str] | None = None
    for name in names:
        last = name.rpartition(".")[2]
        if last not in module.text:
            continue
        there = [*imported_names(module.text, file.rpartition("/")[0])] if there is None else there
        path = name.replace(".", "/")
        if any(each == name or each.startswith(f"{name}.") or f"/{path}/" in f"/{each}/" for each in there):
            line = module.text.count("\n", 0, module.text.index(last)) + 1
            yield Mention(
                topic="needs_extension", value=name, source="code", file=file, line=line, text=name, inside=start
            )
