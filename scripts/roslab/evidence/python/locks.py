"""Releases that a lock at the root, or of the one project of a tree, names.

They are uv.lock, poetry.lock, pdm.lock and pipenv's Pipfile.lock.

https://docs.astral.sh/uv/concepts/projects/layout/#the-lockfile, https://python-poetry.org/docs/basic-usage/ and
https://pdm-project.org/latest/usage/lockfile/, read 2026-11-23.
The first three are TOML with a table for each release.
"""

from __future__ import annotations

import posixpath
import re
from collections import Counter
from collections.abc import Iterator
from typing import Any

from roslab.evidence import places
from roslab.evidence.locked import Locked
from roslab.evidence.python import pipfile
from roslab.repository.checkout import Repository
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern
from roslab.values.requirement_line import stated
from roslab.values.version import version_of

LOCKS = ("uv.lock", "poetry.lock", "pdm.lock", pipfile.LOCK)
_INDEXES = frozenset({"registry", "legacy", "pypi"})
"""What uv and Poetry call an index: what comes from elsewhere is no release."""
_ELSEWHERE = frozenset({"git", "path", "url"})
"""Keys with which pdm tells that a package comes from elsewhere."""
# Each begins with the end of the line before, which is found many times faster than the beginning of a line
_UNREAD = pattern(
    r"\n\[package\.(?:metadata|optional-dependencies|dev-dependencies|extras)[\].][^\n]*(?:\n(?!\[)[^\n]*)*"
)
"""A table of which nothing is taken: what the author wrote, and what is only installed with an extra."""
_SOURCE = pattern(r"\nsdist = \{[^\n]*\}$", re.MULTILINE)
_FILES = pattern(
    r"\n(wheels|files) = \[(\n(?:[ \t]*\{ ?(?:url|file) = \"[^\"'\\\n#]*\"[^\n]*\},?\n)+)\]$", re.MULTILINE
)
"""A list of files, each on a line of its own with its address, hash, size and time."""
_FILE = pattern(r"\n[ \t]*\{ ?\w+ = \"(?:[^\"\n]*/)?([^\"\n/]*)")
_NEEDS = pattern(r"\ndependencies = \[(\n(?:[ \t]*\{ ?name = \"[\w.-]+\"[^\n]*\},?\n)+)\]$", re.MULTILINE)
"""A list of packages, each on a line of its own with its extras and marker."""
_NEED = pattern(r"\n[ \t]*\{ ?name = \"([^\"]*)")
_BETWEEN = "/"
"""What no name of a file or package has."""


def read(repository: Repository) -> tuple[Locked, ...]:
    """Return the releases of the first lock that the root has; one that is no TOML tells nothing.

    Else those of the lock beside the one project of Python that the tree has.
    """
    file = next((name for name in LOCKS if repository.has(name)), None) or _of_the_project(repository)
    if file is None:
        return ()
    text = repository.read(file)
    if file.endswith(pipfile.LOCK):
        every = (_release(table, file, line, "") for table, line in pipfile.locked(text))
        return tuple(each for each in every if each)
    from roslab.values import toml  # noqa: PLC0415 - few trees have a lock

    try:
        packages = toml.parsed(_thinned(text)).get("package")
    except ValueError:
        return ()
    lines = [number for number, line in enumerate(text.split("\n"), 1) if line.strip() == "[[package]]"]
    tables = packages if isinstance(packages, list) and len(packages) == len(lines) else []
    pairs = [(table, line) for table, line in zip(tables, lines, strict=False) if isinstance(table, dict)]
    usual = Counter(_index(table) for table, _ in pairs).most_common(1)
    found = (_release(table, file, line, usual[0][0]) for table, line in pairs)
    return tuple(each for each in found if each)


def _of_the_project(repository: Repository) -> str | None:
    """Return the only lock of a tree without packages of ROS, if each project of Python lies beside or below it."""
    found = [file for name in LOCKS for file in repository.named(name)]
    if len(found) != 1 or places.aside(found[0].path) or repository.named("package.xml"):
        return None
    projects = repository.named("pyproject.toml", "setup.py", pipfile.NAME)
    folder = found[0].folder
    beside = any(file.folder == folder for file in projects)
    return found[0].path if beside and all(file.path.startswith(f"{folder}/") for file in projects) else None


def _thinned(text: str) -> str:
    """Return a lock with one text in place of a list: most of it is addresses and hashes, which are slow to parse.

    What nobody asks for is left out.

    A list that is written in another way than its tool does stays as it is. The text is a literal one of TOML: in
    others each letter is looked at, since it could begin an escape.
    """
    text = _SOURCE.sub("\n", _UNREAD.sub("", text))
    text = _FILES.sub(lambda found: f"\n{found[1]} = {_literal(_FILE.findall(found[2]))}", text)
    return _NEEDS.sub(lambda found: f"\ndependencies = {_literal(_NEED.findall(found[1]))}", text)


def _literal(names: list[str]) -> str:
    return f"'{_BETWEEN.join(names)}'"


def _index(table: dict[str, Any]) -> str:
    """Return the address of the index that a release is from, ``""`` for that of its tool."""
    source = table.get("source")
    return str(source.get("registry") or source.get("url") or "") if isinstance(source, dict) else ""


def _release(table: dict[str, Any], file: str, line: int, usual: str) -> Locked | None:
    name, version = str(table.get("name", "")), version_of(str(table.get("version", "")))
    if not name or version is None or not _of_an_index(table):
        return None
    line_of_it = stated(f"{canonicalize_name(name)}=={version}", "lock", file, line)
    wheels = tuple(each for each in _files(table) if each.endswith(".whl"))
    return Locked(
        requirement=line_of_it.only_if(_condition(table)),
        wheels=wheels,
        needs=tuple(_needs(table)),
        elsewhere=_index(table) != usual and not version.local,
    )


def _of_an_index(table: dict[str, Any]) -> bool:
    source = table.get("source")
    kinds = {str(source.get("type", ""))} | {*source} if isinstance(source, dict) else {"registry"}
    return bool(kinds & _INDEXES) and not _ELSEWHERE & {*table}


def _condition(table: dict[str, Any]) -> str:
    """Return the marker under which the release is meant, ``""`` where it always is."""
    said = table.get("resolution-markers", table.get("markers", table.get("marker")))
    every = said if isinstance(said, list) else [said]
    return " or ".join(f"({each})" for each in every if isinstance(each, str))


def _files(table: dict[str, Any]) -> Iterator[str]:
    for each in (*_listed(table, "wheels"), *_listed(table, "files")):
        said = each.get("file") or each.get("url") or "" if isinstance(each, dict) else each
        yield posixpath.basename(str(said).partition("#")[0])


def _needs(table: dict[str, Any]) -> Iterator[str]:
    """Yield what a release needs: a list of tables of uv's, a table of Poetry's, a list of lines of pdm's."""
    said = table.get("dependencies")
    if isinstance(said, (dict, str)):
        yield from map(canonicalize_name, said.split(_BETWEEN) if isinstance(said, str) else said)
        return
    for each in _listed(table, "dependencies"):
        named = str(each.get("name", "")) if isinstance(each, dict) else stated(str(each)).name
        if named:
            yield canonicalize_name(named)


def _listed(table: dict[str, Any], key: str) -> list[Any]:
    """Return a list, or what stands in its place."""
    found = table.get(key)
    if isinstance(found, str):
        return found.split(_BETWEEN)
    return found if isinstance(found, list) else []
