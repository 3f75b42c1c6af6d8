"""Programs that import a package which lies above their own folder, and below the root."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.python.from_root import LAYOUTS, imported_from, modules_in, places_at_root
from roslab.evidence.python.modules import has_guard, modules, run_by_pages
from roslab.evidence.python.sibling_folders import known_modules
from roslab.evidence.python.through_modules import names_inside, of_tree
from roslab.repository.checkout import File, Repository


def read(repository: Repository, mentions: Iterable[Mention]) -> Iterator[Mention]:
    """Yield each folder above a program's own from which it imports modules or packages by their names.

    That is ``tracker`` for ``tracker/tools/run.py`` with ``from net.model import Net``: pages go there before they
    start it, and Python looks into the program's own folder, not where it is started
    (https://docs.python.org/3/library/sys.html#sys.path, read 2026-11-27). None that has a package called like a known
    one, which it would hide. ``inside`` is the folder, ``files`` the modules in it.
    """
    run = run_by_pages(mentions)
    for module in modules(repository):
        program = module.file
        offered = program.path in run or has_guard(module)
        found = dict(_found(repository, program)) if offered and "/" in program.folder else {}
        for folder, (name, line) in imported_from(module, repository, found).items() if found else ():
            hidden = repository.once(modules_in).get(folder, set())
            if known_modules().isdisjoint((name, *hidden)):
                yield Mention(
                    topic="from_above",
                    value=name,
                    source="code",
                    file=program.path,
                    line=line,
                    text=f"import {name}",
                    files=tuple(sorted(hidden)),
                    inside=folder,
                )


def _above(folder: str) -> Iterator[str]:
    """Yield the folders above one, the nearest first, without the root."""
    while folder := posixpath.dirname(folder):
        yield folder


def _found(repository: Repository, program: File) -> Iterator[tuple[str, str]]:
    """Yield the names that a program imports and that Python would find above its folder alone, with that folder."""
    at_root = repository.once(places_at_root)
    inside = repository.once(_inside)
    tops = {name.partition(".")[0] for name in of_tree(repository).imported(program.path)}
    for name in tops - at_root.keys():
        for folder in _above(program.folder):
            if folder not in LAYOUTS and name in inside.get(folder, ()):
                yield name, folder
                break


def _inside(repository: Repository) -> dict[str, set[str]]:
    return names_inside(file.path for file in repository.suffixed(".py"))
