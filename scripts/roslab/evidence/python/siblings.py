"""Packages of the tree that another one of it imports: who installs that one needs them, too."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.python.imports import modules_of
from roslab.evidence.python.modules import modules
from roslab.evidence.python_project import PythonProject
from roslab.repository.checkout import Repository


def read(repository: Repository, projects: Iterable[PythonProject]) -> Iterator[Mention]:
    """Yield the folder of each package that a module of another one imports under no condition, once for a folder.

    A project at the root is not asked: it may bring what lies in the folders below it.
    """
    folders = [each.folder for each in projects if each.folder and each.installable]
    found = [(name, folder) for folder in folders for name in _packages(repository, folder)] if folders[1:] else []
    several = Counter(name for name, _ in found)  # such as tests or utils
    tops = {name: folder for name, folder in found if several[name] == 1}
    if not tops:
        return
    told: set[tuple[str, str]] = set()
    for module in modules(repository):
        path = module.file.path
        own = max((each for each in folders if path.startswith(f"{each}/")), key=len, default=None)
        if own is None or places.test(path) or places.example(path):
            continue
        for match in module.statements:
            for name in modules_of(match) if not match["indent"] else ():
                other = tops.get(name, own)
                if other != own and (own, other) not in told:
                    told.add((own, other))
                    line = module.text.count("\n", 0, match.start()) + 1
                    yield Mention(
                        topic="sibling", value=other, source="code", file=path, line=line, text=f"import {name}"
                    )


def _packages(repository: Repository, folder: str) -> Iterator[str]:
    """Yield the top-level packages of a project, which lie in its folder or in ``src``."""
    for place in (folder, f"{folder}/src"):
        for file in repository.named("__init__.py"):
            above, _, name = file.folder.rpartition("/")
            if above == place:
                yield name
