"""Programs below the root that import what lies at the root: from their own folder Python does not find it."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.python.modules import Module, modules, run_by_pages
from roslab.knowledge.standard_modules import standard_modules
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_IMPORT = pattern(
    r"(?:from[ \t]+([A-Za-z_]\w*)(?:\.(\w+))?[\w.]*[ \t]+import[ \t]+\(?\s*(\w+)?|"
    r"import[ \t]+([A-Za-z_]\w*)(?:\.(\w+))?)",
)
_PATH = "sys.path"
_TABLES = ("[project]", "[build-system]", "[tool.poetry]")


def read(repository: Repository, mentions: Iterable[Mention]) -> Iterator[Mention]:
    """Yield each program in a folder that imports a module or a package of the root, by its name.

    Programs are what a page runs and what has a ``__main__`` guard. Python looks into a program's own folder, not where
    it is started (https://docs.python.org/3/library/sys.html#sys.path, read 2026-11-25), unless the program or a module
    beside it adds to that path before.
    """
    if _installs(repository):
        return
    run = run_by_pages(mentions)
    names = _at_root(repository)
    for module in modules(repository) if names else ():
        file = module.file
        started = "__main__" in module.words and not places.test(file.path)
        if not file.folder or not (file.path in run or started) or not any(name in module.text for name in names):
            continue
        if found := _from_root(module, repository, names):
            name, line = found
            yield Mention(
                topic="from_root", value=name, source="code", file=file.path, line=line, text=f"import {name}"
            )


def _installs(repository: Repository) -> bool:
    """Tell whether pip can install the repository itself, whose packages are found from anywhere then."""
    manifest = repository.read("pyproject.toml") if repository.has("pyproject.toml") else ""
    setup = repository.read("setup.py") if repository.has("setup.py") else ""
    return "setup(" in setup or any(table in manifest for table in _TABLES)


def _at_root(repository: Repository) -> frozenset[str]:
    """Return the names of the modules and packages that Python finds from the root."""
    files = [file for file in repository.suffixed(".py") if not places.vendored(file.path)]
    names = {file.path.partition("/")[0].removesuffix(".py") for file in files}
    names = {name for name in names if name.isidentifier() and name not in sys.stdlib_module_names}
    return frozenset(names) - standard_modules() - {"setup", "conftest"}


def _from_root(module: Module, repository: Repository, names: frozenset[str]) -> tuple[str, int] | None:
    """Return the first name that a program imports from the root alone, with the line; ``None`` if there is none."""
    folder = module.file.folder
    first: tuple[str, int] | None = None
    for number, line in enumerate(module.text.splitlines(), start=1):
        if _PATH in line:
            return first
        match = _IMPORT.match(line) if line.startswith(("from ", "import ")) else None
        if match is None:
            continue
        name, inner = match[1] or match[4], match[2] or match[3] or match[5]
        if first is None and repository.has(f"{folder}/{name}.py"):
            if _PATH in repository.read(f"{folder}/{name}.py"):
                return None
        elif name in names and f"{folder}/{name}" not in repository.folders and first is None:
            first = (name, number) if _there(name, inner, repository) else None
    return first


def _there(name: str, inner: str | None, repository: Repository) -> bool:
    """Tell whether a module or package is at the root; a folder without ``__init__.py`` has to have what is named."""
    if repository.has(f"{name}.py") or repository.has(f"{name}/__init__.py"):
        return True
    return bool(inner) and (repository.has(f"{name}/{inner}.py") or f"{name}/{inner}" in repository.folders)
