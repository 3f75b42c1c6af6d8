"""Modules that a setup.py of the tree compiles: no file of Python has their name. Those of CMake are its targets."""

from __future__ import annotations

from roslab.evidence import places
from roslab.knowledge.frameworks import imports as known_imports
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_EXTENSION = pattern(r"\b\w*Extension\s*\(\s*(?:name\s*=\s*)?[\"']([A-Za-z_][\w.]*)[\"']")
"""``Extension``, and those of PyTorch and pybind11;
https://setuptools.pypa.io/en/latest/userguide/ext_modules.html, read 2026-11-27."""


def compiled_modules(repository: Repository) -> frozenset[str]:
    """Return the names by which a program imports what setup.py compiles: ``a`` for ``a._C``.

    What copied code compiles under the name of a known package may not be compiled here: the package brings it.
    """
    files = [file for file in repository.named("setup.py") if not places.test(file.path)]
    texts = ((file, text) for file in files if "Extension" in (text := repository.read(file)))
    found = ((match[1].partition(".")[0], file.path) for file, text in texts for match in _EXTENSION.finditer(text))
    return frozenset(name for name, path in found if name not in known_imports() or not places.vendored(path))
