"""The programs that a project installs, without those whose module it no longer has: they start nothing."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.repository.checkout import Repository

ENTRIES = ("console_scripts", "gui_scripts")
"""Groups of entry points of which pip makes a program each; on Linux those with windows are like the others:
https://packaging.python.org/en/latest/specifications/entry-points/#use-for-scripts, 2026-11-29"""
_CODE = (".py", ".pyx", ".so", ".c", ".cpp", ".rs")


def startable(repository: Repository, folder: str, entries: Iterable[str]) -> Iterator[str]:
    """Yield the names of entries (``run = planner.node:main``) but those whose module no file of the tree is.

    Only where the project has the package that it should lie in: others are made or brought.
    """
    for entry in entries:
        name, _, target = entry.partition("=")
        if not _gone(repository, folder, target.partition(":")[0].strip()):
            yield name.strip()


def modules_of(entries: Iterable[str]) -> Iterator[str]:
    """Yield the whole name of the module that each entry starts."""
    for entry in entries:
        if module := entry.partition("=")[2].partition(":")[0].strip():
            yield module


def _gone(repository: Repository, folder: str, module: str) -> bool:
    package, _, last = module.rpartition(".")
    if not package or not all(map(str.isidentifier, module.split("."))):
        return False
    top = package.partition(".")[0]
    places = [
        place for place in (f"{folder}/", f"{folder}/src/") if repository.has(f"{place}{top}/__init__.py".lstrip("/"))
    ]
    path = module.replace(".", "/")
    if not places or any(f"{place}{path}".lstrip("/") in repository.folders for place in places):
        return False
    files = repository.named(*(f"{last}{suffix}" for suffix in _CODE))
    return not any(f"/{file.path.rpartition('.')[0]}".endswith(f"/{path}") for file in files)
