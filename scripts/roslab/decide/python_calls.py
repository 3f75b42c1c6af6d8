"""Calls of Python as a page writes them, as they can be made from the root of the tree."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable

from roslab.decide.scripts import bare
from roslab.evidence.facts import Mention


def modules_called(name: str, programs: Iterable[str]) -> list[tuple[str, str]]:
    """Return the programs that ``python -m`` means by a name, each after the folder to search, "" for the root."""
    path = name.replace(".", "/")
    ends = (f"/{path}.py", f"/{path}/__main__.py")
    found = [f"/{program}" for program in programs if f"/{program}".endswith(ends)]
    return [(file.removesuffix(ends[0]).removesuffix(ends[1])[1:], file[1:]) for file in found]


def module_of(
    argv: tuple[str, ...], programs: tuple[str, ...], page: Mention, projects: tuple[str, ...], *, by_path: bool
) -> tuple[str, ...] | None:
    """Return the arguments of ``python -m`` if the module is at the root, or the one of that name below a folder.

    That is one of ``projects``, which pip installs and whose packages any folder may import, or the one that the page
    goes to; or any, where PYTHONPATH can name it (``by_path``) and the name is dotted, as that of a package.
    """
    above = (*projects, *filter(None, (page.inside,)))
    name = argv[2] if len(argv) > 2 else ""
    found = modules_called(name, programs)
    if not any(not folder for folder, _ in found):
        if len(found) != 1:
            return None
        inside = any(not folder or found[0][1].startswith(f"{folder}/") for folder in above)
        if not inside and not (by_path and "." in name):
            return None
    return argv[1:]


def program_here(argv: tuple[str, ...], programs: tuple[str, ...], folder: str) -> tuple[str, ...] | None:
    """Return the arguments of a Python that runs a program of the tree, its path from the root; else ``None``.

    ``folder``: that of the page, whose own program is meant where others have the same name.
    """
    for position, part in enumerate(argv[1:], 1):
        if part.endswith(".py") or (bare(part) and part in programs):
            path = posixpath.normpath(part)
            beside = [near for near in (path, f"{folder}/{path}") if near in programs]
            ends = beside[:1] or [program for program in programs if program.endswith("/" + path)]
            return (*argv[1:position], ends[0], *argv[position + 1 :]) if len(ends) == 1 else None
    return None
