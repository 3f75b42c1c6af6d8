"""Programs that import what lies at the root or in `src`: from their own folder Python does not find it."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Mapping

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.python.lenient import tables
from roslab.evidence.python.modules import Module, has_guard, modules, run_by_pages
from roslab.evidence.python.stopped_setup import why_refused
from roslab.knowledge.standard_modules import standard_modules
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_IMPORT = pattern(
    r"(?:from[ \t]+([A-Za-z_]\w*)(?:\.(\w+))?[\w.]*[ \t]+import[ \t]+\(?\s*(\w+)?|"
    r"import[ \t]+([A-Za-z_]\w*)(?:\.(\w+))?)",
)
_PATH = "sys.path"
_OWN_FOLDER = pattern(
    r"sys\.path\.(?:append\(|insert\(0, ?)(?:str\()?"
    r"(?:os\.path\.dirname\((?:os\.path\.(?:abs|real)path\()?__file__\)?\)|Path\(__file__\)(?:\.resolve\(\))?\.parent)"
    r"\)?\)[ \t]*(?:#.*)?"
)
"""A line that adds a program's own folder, which Python looks into anyway."""
LAYOUTS = ("src", "python", "lib")
"""Folders for packages: https://packaging.python.org/en/latest/discussions/src-layout-vs-flat-layout/"""
CODE = (".py", ".pyx", ".so")
"""What Python imports."""
_INIT = "__init__.py"
_TABLES = ("[project]", "[build-system]", "[tool.poetry]")


def read(repository: Repository, mentions: Iterable[Mention]) -> Iterator[Mention]:
    """Yield each program that imports a module or a package of the root, or of a folder for them, by its name.

    Programs are what a page runs and what has a ``__main__`` guard. Python looks into a program's own folder, not where
    it is started (https://docs.python.org/3/library/sys.html#sys.path, read 2026-11-25), unless the program or a module
    beside it adds to that path before. ``inside`` is the folder, ``""`` the root, ``files`` the modules in it.
    """
    if installs_itself(repository):
        return
    run = run_by_pages(mentions)
    places_of = repository.once(places_at_root)
    beside = {place: tuple(sorted(repository.once(modules_in)[place])) for place in {*places_of.values()}}
    for module in modules(repository) if places_of else ():
        file = module.file
        names = {name: place for name, place in places_of.items() if file.folder or place}
        if not (file.path in run or has_guard(module)) or not any(name in module.text for name in names):
            continue
        for place, (name, line) in imported_from(module, repository, names).items():
            yield Mention(
                topic="from_root",
                value=name,
                source="code",
                file=file.path,
                line=line,
                text=f"import {name}",
                files=beside[place],
                inside=place,
            )


def installs_itself(repository: Repository) -> bool:
    """Tell whether pip can install the repository itself, whose packages are found from anywhere then."""
    manifest = repository.read("pyproject.toml") if repository.has("pyproject.toml") else ""
    setup = repository.read("setup.py") if repository.has("setup.py") else ""
    if "setup(" not in setup and not any(table in manifest for table in _TABLES):
        return False
    return not manifest or not why_refused(*tables(manifest))


def places_at_root(repository: Repository) -> dict[str, str]:
    """Return the modules and packages that Python finds from the root, and from folders for them, with these folders.

    Of two of one name that at the root is meant.
    """
    found: dict[str, str] = {}
    files = [file.path for file in repository.suffixed(".py") if not places.vendored(file.path)]
    for place in ("", *LAYOUTS):
        start = f"{place}/" if place else ""
        for path in files:
            name = path.removeprefix(start).partition("/")[0].removesuffix(".py")
            if path.startswith(start) and name.isidentifier() and name not in sys.stdlib_module_names:
                found.setdefault(name, place)
    return {name: place for name, place in found.items() if name not in standard_modules() | {"setup", "conftest"}}


def imported_from(module: Module, repository: Repository, names: Mapping[str, str]) -> dict[str, tuple[str, int]]:
    """Return for each folder the first name that a program imports from there alone, with the line."""
    start = f"{module.file.folder}/" if module.file.folder else ""
    found: dict[str, tuple[str, int]] = {}
    for number, line in enumerate(module.text.splitlines(), start=1):
        if _PATH in line and not _OWN_FOLDER.fullmatch(line):
            return found
        for name, inner in _names(line) if line.startswith(("from ", "import ")) else ():
            if not found and repository.has(f"{start}{name}.py"):
                if _PATH in repository.read(f"{start}{name}.py"):
                    return {}
            elif (
                name in names
                and f"{start}{name}" not in repository.folders
                and _there(name, inner, repository, names[name])
            ):
                found.setdefault(names[name], (name, number))
    return found


def _names(line: str) -> Iterator[tuple[str, str | None]]:
    """Yield the first part of each name that a line imports, with what it names in that: ``import gym, net.model``."""
    named = line[6:].partition("#")[0].split(",")
    parts = [line] if line.startswith("from") else [f"import {part.strip()}" for part in named]
    for match in filter(None, map(_IMPORT.match, parts)):
        yield match[1] or match[4], match[2] or match[3] or match[5]


def _there(name: str, inner: str | None, repository: Repository, place: str) -> bool:
    """Tell whether a module or package is in a folder; one without ``__init__.py`` has to have what is named."""
    path = f"{place}/{name}" if place else name
    if repository.has(f"{path}.py") or repository.has(f"{path}/__init__.py"):
        return True
    return bool(inner) and (repository.has(f"{path}/{inner}.py") or f"{path}/{inner}" in repository.folders)


def modules_in(repository: Repository) -> dict[str, set[str]]:
    """Return the names that Python finds in each folder; one without ``__init__.py`` hides no installed package."""
    found: dict[str, set[str]] = {"": set(), **{layout: set() for layout in LAYOUTS}}
    for file in repository.suffixed(*CODE):
        above, _, name = file.folder.rpartition("/")
        if file.name == _INIT:
            found.setdefault(above, set()).add(name)
        else:
            found.setdefault(file.folder, set()).add(file.name.partition(".")[0])
    return found
