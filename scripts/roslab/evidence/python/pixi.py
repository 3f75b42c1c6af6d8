"""pixi's environments, in pixi.toml or pyproject.toml: conda's packages, pip's, and tasks.

https://pixi.sh/latest/reference/pixi_manifest/, read 2026-11-21.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from roslab.evidence.conda_environment import CondaEnvironment
from roslab.repository.checkout import File, Repository
from roslab.values.conda import conda_package, named_python
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import requirement

MAX_SIZE = 256 * 1024
_HERE = ("linux-64", "linux", "unix")
"""Targets that hold in the image."""


def read(repository: Repository) -> tuple[CondaEnvironment, ...]:
    """Return the default environment of each of pixi's manifests, sorted by path."""
    files = [file for file in repository.suffixed(".toml") if file.name in {"pixi.toml", "pyproject.toml"}]
    found = (_environment(repository, file) for file in sorted(files, key=lambda file: file.path))
    return tuple(environment for environment in found if environment)


def _environment(repository: Repository, file: File) -> CondaEnvironment | None:
    from roslab.evidence.python.pixi_lock import releases  # noqa: PLC0415 - few trees use pixi
    from roslab.values import toml  # noqa: PLC0415 - few trees use pixi

    text = repository.read(file, limit=MAX_SIZE)
    if file.name != "pixi.toml" and "[tool.pixi" not in text:
        return None
    try:
        data = toml.parsed(text)
    except ValueError:
        return None
    data = data if file.name == "pixi.toml" else _table(_table(data, "tool"), "pixi")
    about = _table(data, "workspace") or _table(data, "project")
    tables = [data, *(_table(_table(data, "target"), name) for name in _HERE)]
    locked = releases(repository, file.folder)
    specs = tuple(spec for table in tables for spec in _specs(_table(table, "dependencies"), locked))
    if not about or not specs:
        return None
    lines = text.split("\n")
    packages = tuple(package for spec in specs if (package := conda_package(spec)))
    channels = about.get("channels")
    return CondaEnvironment(
        file=file.path,
        line=1,
        name=None,
        python=named_python(packages),
        packages=packages,
        requirements=tuple(r for table in tables for r in _pip(_table(table, "pypi-dependencies"), file.path, lines)),
        channels=tuple(map(str, channels)) if isinstance(channels, list) else (),
        specs=specs,
        tasks=tuple(_tasks(_table(data, "tasks"), lines)),
    )


def _specs(dependencies: dict[str, Any], locked: dict[str, str]) -> Iterator[str]:
    """Yield conda's way of writing what pixi asks for, at the versions of its lock."""
    from roslab.evidence.python.pixi_lock import pinned  # noqa: PLC0415 - few trees use pixi

    for name, said in dependencies.items():
        version = said.get("version", "*") if isinstance(said, dict) else said
        if isinstance(version, str) and not (isinstance(said, dict) and "path" in said):
            yield pinned(name, version.strip().replace(" ", ""), locked)


def _pip(dependencies: dict[str, Any], file: str, lines: list[str]) -> Iterator[Requirement]:
    """Yield pip's packages; what lies in the tree is installed as a project."""
    from roslab.evidence.python.poetry import lines as of_poetry  # noqa: PLC0415 - many trees have no pyproject.toml

    for name, said in dependencies.items():
        number = next((n for n, line in enumerate(lines, 1) if name in line), 1)
        if isinstance(said, dict) and "path" in said:
            continue
        if isinstance(said, dict) and isinstance(said.get("index"), str):
            written = f"--extra-index-url {said['index']}"
            yield Requirement(name="", written=written, origin="conda", role="option", file=file, line=number)
        for text in of_poetry({name: said}):  # written like Poetry's
            if asked := requirement(text, "conda", file, number):
                yield asked


def _tasks(tasks: dict[str, Any], lines: list[str]) -> Iterator[tuple[str, str, int]]:
    for name, said in tasks.items():
        command = said.get("cmd") if isinstance(said, dict) else said
        if isinstance(command, list):
            command = " ".join(map(str, command))
        if isinstance(command, str):
            yield name, " ".join(command.split()), next((n for n, line in enumerate(lines, 1) if name in line), 1)


def _table(data: dict[str, Any], key: str) -> dict[str, Any]:
    found = data.get(key)
    return found if isinstance(found, dict) else {}
