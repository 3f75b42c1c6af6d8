"""Programs that other modules of the tree import: their guard is for a try, and another program is meant."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable

from roslab.evidence import places
from roslab.evidence.python.modules import modules
from roslab.repository.checkout import Repository

MOST = 40
"""Most programs for which importing modules are looked for."""


def imported_programs(repository: Repository, programs: Iterable[str]) -> frozenset[str]:
    """Return those of the programs that another module, no test, imports; a name that several files have tells nothing.

    ``programs``: files at the root or one folder down.
    """
    stems = {path.rpartition("/")[2].removesuffix(".py"): path for path in programs}
    alone = {stem: path for stem, path in stems.items() if len(repository.named(f"{stem}.py")) == 1}
    wanted = {stem: path for stem, path in alone.items() if stem not in sys.stdlib_module_names and stem.isidentifier()}
    if not 1 < len(stems) <= MOST or not wanted:
        return frozenset()
    statement = {stem: _importing(stem) for stem in wanted}
    found: set[str] = set()
    for module in modules(repository):
        path = module.file.path
        if places.test(path) or "import" not in module.text:
            continue
        for stem, own in wanted.items():
            if own not in found and own != path and stem in module.text and statement[stem].search(module.text):
                found.add(own)
    return frozenset(found)


def _importing(stem: str) -> re.Pattern[str]:
    name = re.escape(stem)
    return re.compile(
        rf"^[ \t]*(?:from[ \t]+(?:[\w.]*\.)?{name}[ \t]+import\b|import[ \t]+(?:[\w.]+\.)?{name}\b|"
        rf"from[ \t]+[\w.]+[ \t]+import[ \t]+(?:\w+[ \t]*,[ \t]*)*{name}\b)",
        re.MULTILINE,
    )
