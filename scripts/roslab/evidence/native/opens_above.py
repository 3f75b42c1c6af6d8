"""Folders of the tree that a program of C++ opens from the folder above the one it is started in: ``../data/a.txt``."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator
from itertools import islice

from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Mention
from roslab.evidence.lex.cmake import FROM_HERE, calls
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 40
"""Most files of a program that are searched, as its project lists them."""
MAX_PROGRAMS = 200
_CODE = (".cpp", ".cc", ".cxx", ".c", ".cu")
_PROGRAM = frozenset({"add_executable", "cuda_add_executable"})
_PATH = pattern(r"\"((?:/?\.\./)?[\w-]+(?:/[\w.-]*)+)")
_OTHER = pattern(r"[ \t]*(?:#|//|\*)")
"""How a line begins that opens nothing: an include, a comment."""
_ABOVE, _BEHIND = "../", "/../"
_BEFORE = pattern(r"=\s*\"\.\./?\"\s*[;,]")
"""A variable that is put before paths: ``dataPath = "../"``."""
_WHERE = pattern(r"\bgetenv\s*\(\s*\"PWD\"\s*\)|\b(?:getcwd|get_current_dir_name|current_path)\s*\(")
"""Where a program is started, before which ``/../data`` is put."""


def read(repository: Repository, projects: Iterable[CMakeProject]) -> Iterator[Mention]:
    """Yield, for a program, the folder as its path from the root; the program is the mention's text.

    It is one that lies beside the build folder of its project, and that the files which the project compiles it from,
    or the one that is named after it, open so. Not where they open what is there from the project's own folder, too.
    """
    files = _files(repository, tuple(projects))
    for (name, top), paths in islice(files.items(), MAX_PROGRAMS):
        if found := _above(repository, tuple(islice(paths, MAX_FILES)), top):
            folder, file, line = found
            yield Mention(topic="above", value=folder, source="code", file=file, line=line, text=name)


def _files(repository: Repository, projects: tuple[CMakeProject, ...]) -> dict[tuple[str, str], dict[str, None]]:
    """Return the files of code of each program, by its name and the folder of its whole project."""
    named: dict[str, list[CMakeProject]] = {}
    for each in projects:
        for name, _ in each.executables:
            named.setdefault(name, []).append(each)
    found: dict[tuple[str, str], dict[str, None]] = {}
    for file in repository.suffixed(*_CODE) if named else ():
        name = file.name.rpartition(".")[0]
        project = _of(file.path, named.get(name, []))
        if project and not _aside(file.path):
            found.setdefault((name, project.top), {})[file.path] = None
    for each in projects:
        own = {name for name, _ in each.executables}
        for name, path in _listed(repository, each) if own else ():
            if name in own and not _aside(path):
                found.setdefault((name, each.top), {})[path] = None
    return found


def _listed(repository: Repository, project: CMakeProject) -> Iterator[tuple[str, str]]:
    """Yield the files of code that a project compiles its programs from, each behind its program."""
    for call in calls(repository.read(project.file), _PROGRAM):
        for word in call.words[1:]:
            path = posixpath.normpath(posixpath.join(posixpath.dirname(project.file), FROM_HERE.sub("", word)))
            if path.endswith(_CODE) and repository.has(path):
                yield call.words[0], path


def _of(path: str, named: list[CMakeProject]) -> CMakeProject | None:
    """Return the project of a program that is nearest around its file; the only one of its name may lie beside it."""
    folder = posixpath.dirname(path)
    around = [each for each in named if f"{folder}/".startswith(posixpath.join(posixpath.dirname(each.file), ""))]
    if not around and len(named) == 1:
        return named[0]
    return max(around, key=lambda each: len(posixpath.dirname(each.file)), default=None)


def _aside(path: str) -> bool:
    return places.vendored(path) or places.test(path)


def _above(repository: Repository, files: tuple[str, ...], top: str) -> tuple[str, str, int] | None:
    """Return the first folder of those that the files open so, with the file and the line of it."""
    texts = {file: repository.read(file, limit=MAX_SIZE) for file in files}
    if not any(f'"{_ABOVE}' in text or f'"{_BEHIND}' in text for text in texts.values()):
        return None
    first: tuple[str, str, int] | None = None
    for file, text in texts.items():
        before, where = _BEFORE.search(text), _WHERE.search(text)
        for match in _PATH.finditer(text):
            if _OTHER.match(text, text.rfind("\n", 0, match.start()) + 1):
                continue
            behind = match[1].startswith(_BEHIND)
            if not behind and not match[1].startswith(_ABOVE):
                if not _has(posixpath.join(top, match[1]), repository):
                    continue
                if not before:
                    return None
            folder = posixpath.join(top, match[1].lstrip("./").partition("/")[0])
            if first is None and (where or not behind) and folder in repository.folders:
                first = folder, file, text.count("\n", 0, match.start(1)) + 1
    return first


def _has(path: str, repository: Repository) -> bool:
    path = posixpath.normpath(path)
    return repository.has(path) or path in repository.folders
