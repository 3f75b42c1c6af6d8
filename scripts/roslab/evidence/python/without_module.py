"""Projects that their build backend refuses to install: they hold no module of their name, several, or say so."""

from __future__ import annotations

import posixpath
from collections.abc import Mapping
from typing import Any

from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_TASKS = r"tests?|examples?|build|tasks|fabfile|benchmarks?|exercises?|[._].*"
_NO_PACKAGE = pattern(
    rf"{_TASKS}|ci|bin|debian|docs?|documentation|manpages|news|newsfragments|changelog|unit_tests?|scripts|tools|utils?|"
    r"python|dist|venv|env|requirements|site_scons"
)
_NO_MODULE = pattern(rf"{_TASKS}|setup|conftest|toxfile|noxfile|pavement|dodo|[Ss][Cc]onstruct|conanfile|manage")
"""What setuptools takes for no part of a project: ``setuptools/discovery.py``, read 2026-11-26."""


def without_module(repository: Repository, folder: str, name: str, data: Mapping[str, Any]) -> bool:
    """Tell whether poetry-core or flit_core finds nothing to install: then only what the project needs can be.

    ``data``: the pyproject.toml. https://python-poetry.org/docs/pyproject/#package-mode, and
    https://flit.pypa.io/en/stable/pyproject_toml.html#module-section, read 2026-11-24.
    """
    backend = str(_table(data, "build-system").get("build-backend", ""))
    tool = _table(data, "tool")
    poetry = _table(tool, "poetry")
    if poetry.get("package-mode") is False:
        return True
    if backend.startswith("poetry") and not {"packages", "include"} & poetry.keys():
        return not _has_module(repository, folder, name)
    if backend.startswith("flit"):
        own = _table(_table(tool, "flit"), "module").get("name") or _table(_table(tool, "flit"), "metadata").get(
            "module"
        )
        return not _has_module(repository, folder, str(own or name))
    if backend.startswith("setuptools") or not backend:
        told = {"packages", "py-modules", "package-dir"} & _table(tool, "setuptools").keys()
        return "project" in data and not told and not _by_setup(repository, folder) and several(repository, folder)
    return False


def _by_setup(repository: Repository, folder: str) -> bool:
    return any(repository.has(posixpath.join(folder, name)) for name in ("setup.py", "setup.cfg"))


def several(repository: Repository, folder: str) -> bool:
    """Tell whether setuptools finds several packages, or several modules and no package, and so takes none of them.

    https://setuptools.pypa.io/en/latest/userguide/package_discovery.html#flat-layout, read 2026-11-26.
    """
    start = f"{folder}/" if folder else ""
    paths = [file.path.removeprefix(start) for file in repository.files if file.path.startswith(start)]
    if any(path.startswith("src/") for path in paths):
        return False
    folders = {path.partition("/")[0] for path in paths if "/" in path}
    if packages := {each for each in folders if each.isidentifier() and not _NO_PACKAGE.fullmatch(each)}:
        return len(packages) > 1
    modules = {path.removesuffix(".py") for path in paths if path.endswith(".py") and "/" not in path}
    return sum(each.isidentifier() and not _NO_MODULE.fullmatch(each) for each in modules) > 1


def _has_module(repository: Repository, folder: str, name: str) -> bool:
    """Tell whether a backend may find a module of that name beside the file or in ``src``, however it is written.

    A folder is none without a file of Python: poetry-core, ``masonry/utils/package_include.py``, read 2026-11-26.
    """
    plain = name.lower().replace("-", "_")
    places = {posixpath.join(folder, start, plain.replace(".", end)) for start in ("", "src") for end in ("/", "_")}
    places = {place.lower() for place in places}
    below = tuple(f"{place}/" for place in places)
    files = (file.path.lower().removesuffix(".py") for file in repository.suffixed(".py"))
    return any(file in places or file.startswith(below) for file in files)


def _table(data: Mapping[str, Any], key: str) -> dict[str, Any]:
    found = data.get(key)
    return found if isinstance(found, dict) else {}
