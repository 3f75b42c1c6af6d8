"""Folders of the tree that a program of C++ opens from the folder above the one it is started in: ``../data/a.txt``."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Mention
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
_CODE = (".cpp", ".cc", ".cxx", ".c", ".cu")
_PATH = pattern(r"\"((?:\.\./)?[\w-]+(?:/[\w.-]*)+)")
_OTHER = pattern(r"[ \t]*(?:#|//|\*)")
"""How a line begins that opens nothing: an include, a comment."""
_ABOVE = "../"


def read(repository: Repository, projects: Iterable[CMakeProject]) -> Iterator[Mention]:
    """Yield, for the file that a program is named after, the folder as its path from the root.

    It is one that lies beside the build folder of its project. Not where the file opens what is there from the
    project's own folder, too.
    """
    named: dict[str, list[CMakeProject]] = {}
    for each in projects:
        for name, _ in each.executables:
            named.setdefault(name, []).append(each)
    for file in repository.suffixed(*_CODE):
        project = _of(file, named.get(file.name.rpartition(".")[0], []))
        if project and file.size <= MAX_SIZE and not (places.vendored(file.path) or places.test(file.path)):
            yield from _of_file(repository, file, project)


def _of(file: File, named: list[CMakeProject]) -> CMakeProject | None:
    """Return the project of a program that is nearest around its file; the only one of its name may lie beside it."""
    around = [each for each in named if f"{file.folder}/".startswith(posixpath.join(posixpath.dirname(each.file), ""))]
    if not around and len(named) == 1:
        return named[0]
    return max(around, key=lambda each: len(posixpath.dirname(each.file)), default=None)


def _of_file(repository: Repository, file: File, project: CMakeProject) -> Iterator[Mention]:
    text = repository.read(file)
    written = _PATH.finditer(text) if f'"{_ABOVE}' in text else ()
    found = [match for match in written if not _OTHER.match(text, text.rfind("\n", 0, match.start()) + 1)]
    for match in found:
        if not match[1].startswith(_ABOVE) and _has(posixpath.join(project.top, match[1]), repository):
            return
    for match in found:
        first = match[1].split("/")[1]
        folder = posixpath.join(project.top, first)
        if match[1].startswith(_ABOVE) and folder in repository.folders:
            line = text.count("\n", 0, match.start(1)) + 1
            yield Mention(topic="above", value=folder, source="code", file=file.path, line=line, text=match[1])
            return


def _has(path: str, repository: Repository) -> bool:
    path = posixpath.normpath(path)
    return repository.has(path) or path in repository.folders
