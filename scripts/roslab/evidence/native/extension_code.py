"""What the sources that a setup.py compiles against a package include or call, and newer releases have dropped."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from roslab.evidence import places
from roslab.evidence.lex.includes import includes
from roslab.evidence.native.cpp import MAX_READ, MAX_SIZE
from roslab.evidence.old_code import OldCode
from roslab.evidence.python_project import PythonProject
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

if TYPE_CHECKING:
    from roslab.knowledge.extension_code import Dropped

MAX_SOURCES = 300
"""Most files that are read for one build script."""
_SOURCES = (".cpp", ".cc", ".cxx", ".c", ".cu")
_HEADERS = (".h", ".hpp", ".hh", ".cuh")
_LISTS = pattern(r"\b(?:r?glob|listdir|walk|scandir)\b")
_CHOOSES = ("TORCH_VERSION", "__has_include")
"""A file with one of them is written for several releases."""


def read(repository: Repository, projects: Iterable[PythonProject]) -> tuple[OldCode, ...]:
    """Return each use at its first place, of each build script apart.

    Only sources that the script names, or of which it lists folders, and the headers that these include count. What
    the code defines itself it does not need of the package.
    """
    scripts = {p.file: p.folder for p in projects if {"cuda", "c"} & {*p.extensions} and p.file.endswith("setup.py")}
    return tuple(use for file, folder in scripts.items() for use in _of(repository, file, folder, {*scripts.values()}))


def _of(repository: Repository, script: str, folder: str, folders: set[str]) -> Iterator[OldCode]:
    from roslab.knowledge.extension_code import dropped  # noqa: PLC0415 - few trees compile for Python

    text = repository.read(script)
    if not any(row.package in text for row in dropped()):
        return
    found: dict[str, OldCode] = {}
    defined: set[str] = set()
    for path, code in compiled(repository, text, folder, folders):
        for row in () if any(word in code for word in _CHOOSES) else dropped():
            if place := _place(row, code):
                line = code.count("\n", 0, place) + 1
                use = OldCode(
                    script=script,
                    package=row.package,
                    below=row.below,
                    define=row.define,
                    what=row.what,
                    file=path,
                    line=line,
                )
                found.setdefault(row.what, use)
            elif place is None:
                defined.add(row.what)
    yield from (use for what, use in found.items() if what not in defined)


def _place(row: Dropped, code: str) -> int | None:
    """Return the position of a use, 0 where there is none, ``None`` where the code defines the name itself."""
    place = 0
    for match in row.pattern.finditer(code) if row.hint in code else ():
        before = code[code.rfind("\n", 0, match.start()) + 1 : match.start()].strip()
        if before.replace(" ", "") == "#define":
            return None
        if "//" not in before and not before.startswith(("*", "#if")):
            place = place or match.end()
    return place


def compiled(repository: Repository, script: str, folder: str, folders: set[str]) -> Iterator[tuple[str, str]]:
    """Yield path and text of the sources that a script compiles, and of the headers in its folder they include.

    ``folders``: those of all such scripts; what lies in one below is of that one.
    """
    inside = f"{folder}/" if folder else ""
    others = tuple(f"{other}/" for other in folders if other != folder and other.startswith(inside))
    own = [
        file
        for file in repository.suffixed(*_SOURCES, *_HEADERS)
        if file.path.startswith(inside) and not file.path.startswith(others) and file.size < MAX_SIZE
    ]
    own = [file for file in own if not places.aside(file.path.removeprefix(inside))]
    every = bool(_LISTS.search(script))
    pending = [file for file in own if file.name.endswith(_SOURCES) and (every or file.name in script)]
    by_name: dict[str, list[File]] = {}
    for file in own:
        by_name.setdefault(file.name, []).append(file)
    seen = {file.path for file in pending}
    for file in pending:  # it grows by what is included
        code = repository.read_bytes(file, limit=MAX_READ).decode("utf-8", errors="replace")
        yield file.path, code
        for match in includes(code):
            for each in by_name.get(match[1].rpartition("/")[2], ()):
                if each.path not in seen and len(seen) < MAX_SOURCES:
                    seen.add(each.path)
                    pending.append(each)
