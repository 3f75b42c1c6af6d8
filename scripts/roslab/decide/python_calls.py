"""Calls of Python as a page writes them, as they can be made from the root of the tree."""

from __future__ import annotations

import posixpath

from roslab.decide.scripts import bare
from roslab.evidence.facts import Mention


def module_of(
    argv: tuple[str, ...], programs: tuple[str, ...], page: Mention, projects: tuple[str, ...], *, by_path: bool
) -> tuple[str, ...] | None:
    """Return the arguments of ``python -m`` if the module is at the root, or the one of that name below a folder.

    That is one of ``projects``, which pip installs and whose packages any folder may import, or the one that the page
    goes to; or any, where PYTHONPATH can name it (``by_path``) and the name is dotted, as that of a package.
    """
    above = (*projects, *filter(None, (page.inside,)))
    module = argv[2].replace(".", "/") if len(argv) > 2 else ""
    files = (f"{module}.py", f"{module}/__main__.py")
    if not {*files} & {*programs}:
        below = [program for program in programs if program.endswith(tuple(f"/{file}" for file in files))]
        if len(below) != 1:
            return None
        if not (
            any(not folder or below[0].startswith(f"{folder}/") for folder in above) or (by_path and "/" in module)
        ):
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
