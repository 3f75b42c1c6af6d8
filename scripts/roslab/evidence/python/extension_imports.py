"""Modules that a setup.py of the tree compiles, where Python imports them."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.python.through_modules import Modules


def needed(found: Modules, file: str, names: Collection[str], start: str) -> Iterator[Mention]:
    """Yield each of the whole names that a module imports at its top, for the program that it is imported by."""
    text = found.by_file[file].text
    for name in names:
        last = name.rpartition(".")[2]
        if last in text and any(_means(each, name) for each in found.imported(file)):
            line = text.count("\n", 0, text.index(last)) + 1
            yield Mention(
                topic="needs_extension", value=name, source="code", file=file, line=line, text=name, inside=start
            )


def _means(imported: str, name: str) -> bool:
    """Tell whether an import, by its whole name or by a path from its module on, is that of a name."""
    path = name.replace(".", "/")
    return imported == name or imported.startswith(f"{name}.") or f"/{path}/" in f"/{imported}/"
