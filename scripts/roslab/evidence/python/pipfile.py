"""Pipfile, what pipenv installs: the packages that the code is run with, and the Python that it is run by.

https://pipenv.pypa.io/en/latest/pipfile.html, read 2026-11-28.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from roslab.evidence.python_project import PythonProject
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern
from roslab.values.requirement_line import requirement

NAME = "Pipfile"
LOCK = "Pipfile.lock"
_VERSION = pattern(r"([23]\.\d{1,2})(?:\.\d{1,2})?")
_OPENED = pattern(r"[ \t{]*\"([\w.-]{1,100})\"[ \t]*:[ \t]*\{")
_KEYS = {"ref": "rev", "file": "url"}
"""What Poetry, whose tables are otherwise the same, calls a key."""


def project(repository: Repository, path: str, folder: str, text: str) -> PythonProject | None:
    """Return what a Pipfile asks for, which is no project that pip installs.

    ``None`` for one that cannot be read, and where a list for pip lies beside it.
    """
    from roslab.evidence.python import poetry  # noqa: PLC0415 - few trees have a Pipfile
    from roslab.values import toml  # noqa: PLC0415 - as above

    if repository.has(f"{folder}/requirements.txt".strip("/")):
        return None
    try:
        data = toml.parsed(text)
    except ValueError:
        return None
    packages = {name: _as_poetry(said) for name, said in _table(data, "packages").items()}
    line_of = poetry.finder_of_keys(text)
    asked = [each for line in poetry.lines(packages) if (each := requirement(line, "manifest", path, line_of(line)))]
    version = _VERSION.fullmatch(str(next((said for key, said in _python(data) if said), "")))
    return PythonProject(
        file=path,
        line=1,
        folder=folder,
        name=None,
        installable=False,
        requires_python=f"=={version[1]}.*" if version else None,
        build_requires=(),
        requirements=tuple(asked),
    )


def locked(text: str) -> Iterator[tuple[dict[str, Any], int]]:
    """Yield a table for each release of a lock, as other locks have it, and its line; nothing for one of no JSON."""
    import json  # noqa: PLC0415 - few trees have such a lock

    try:
        data = json.loads(text)
    except (ValueError, RecursionError):
        return
    lines: dict[str, int] = {}
    for number, line in enumerate(text.split("\n"), 1):
        if opened := _OPENED.match(line):
            lines.setdefault(opened[1], number)
    for name, said in _table(data, "default").items():
        version = said.get("version") if isinstance(said, dict) else None
        if isinstance(version, str) and version.startswith("==") and not {"git", "path", "file"} & said.keys():
            markers = {"markers": said["markers"]} if isinstance(said.get("markers"), str) else {}
            yield {"name": name, "version": version.removeprefix("=="), **markers}, lines.get(name, 1)


def _python(data: Any) -> Iterator[tuple[str, Any]]:
    requires = _table(data, "requires")
    yield from ((key, requires.get(key)) for key in ("python_full_version", "python_version"))


def _as_poetry(said: Any) -> Any:
    if not isinstance(said, dict):
        return said
    return {_KEYS.get(key, key): value for key, value in said.items()}


def _table(data: Any, key: str) -> dict[str, Any]:
    found = data.get(key) if isinstance(data, dict) else None
    return found if isinstance(found, dict) else {}
