"""Packages that are started by their names, ``python -m demo``: their __main__.py may import what is beside it."""

from __future__ import annotations

import re

from roslab.evidence.python.modules import Module
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_IMPORTED = pattern(r"^[ \t]*(?:from|import)[ \t]+(\w+)", re.MULTILINE)
_RELATIVE = pattern(r"^[ \t]*from[ \t]+\.", re.MULTILINE)


def package(repository: Repository, module: Module) -> str:
    """Return the name of the package whose __main__.py a module is; ``""`` for a folder that is started by its path.

    Then Python looks for what it imports beside it (https://docs.python.org/3/using/cmdline.html, read 2026-11-27).
    """
    folder = module.file.folder
    name = folder.removeprefix("src/").replace("/", ".")
    if not all(map(str.isidentifier, name.split("."))):
        return ""
    beside = (f"{folder}/{found[1]}" for found in _IMPORTED.finditer(module.text))
    if any(repository.has(f"{path}.py") or repository.has(f"{path}/__init__.py") for path in beside):
        return ""
    own = any(found[1] == name.partition(".")[0] for found in _IMPORTED.finditer(module.text))
    named = own or repository.has(f"{folder}/__init__.py") or _RELATIVE.search(module.text)
    return name if named else ""
