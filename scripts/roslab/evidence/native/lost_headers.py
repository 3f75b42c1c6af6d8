"""Headers that the sources of a setup.py include and that nothing in the tree is.

What a licensed program makes is told by ``made_headers``; here stands what may be any library's.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.lex.includes import includes
from roslab.evidence.native import made_headers
from roslab.evidence.native.extension_code import compiled
from roslab.evidence.native.limits import conditional
from roslab.evidence.native.nowhere import Nowhere
from roslab.evidence.python_project import PythonProject
from roslab.repository.checkout import Repository

_COMPILES = frozenset({"c", "cython", "cuda"})


def read(repository: Repository, projects: Iterable[PythonProject]) -> Iterator[Mention]:
    """Yield what a licensed program makes, and the first header of each library that is nowhere."""
    projects = tuple(projects)
    yield from made_headers.read(repository, projects)
    scripts = {p.file: p.folder for p in projects if _COMPILES & {*p.extensions} and p.file.endswith("setup.py")}
    for file, folder in scripts.items():
        yield from _of(repository, file, folder, {*scripts.values()})


def _of(repository: Repository, script: str, folder: str, folders: set[str]) -> Iterator[Mention]:
    """Yield the first include of each library's headers, none that the script itself names or that may be left out."""
    text, seen, nowhere = repository.read(script), set[str](), Nowhere(repository, ())
    for path, code in compiled(repository, text, folder, folders):
        for match in includes(code):
            name = match[1]
            library = name.partition("/")[0]
            if library in seen or library in text or not nowhere.of_library(name):
                continue
            if "__has_include" in code or conditional(code, match.start(1)):
                continue
            seen.add(library)
            line = code.count("\n", 0, match.start(1)) + 1
            yield Mention(
                topic="lost_header", value=name, source="code", file=path, line=line, text=match[0], inside=folder
            )
