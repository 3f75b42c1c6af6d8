"""Projects that their build backend refuses to install, for they hold no module of their name or say so."""

from __future__ import annotations

import posixpath
from collections.abc import Mapping
from typing import Any

from roslab.repository.checkout import Repository


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
    return False


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
