"""Modules that a setup.py of the tree compiles: no file of Python has their name. Those of CMake are its targets."""

from __future__ import annotations

from collections.abc import Iterator

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
    found = ((name.partition(".")[0], path) for name, path in _names(repository))
    return frozenset(name for name, path in found if name not in known_imports() or not places.vendored(path))


def whole_names(repository: Repository) -> tuple[str, ...]:
    """Return the whole names of what setup.py compiles: ``a._C``."""
    return tuple(dict.fromkeys(name for name, _ in _names(repository)))


def _names(repository: Repository) -> Iterator[tuple[str, str]]:
    """Yield each such name with the path of its setup.py."""
    files = [file for file in repository.named("setup.py") if not places.test(file.path)]
    texts = ((file, text) for file in files if "Extension" in (text := repository.read(file)))
    yield from ((match[1], file.path) for file, text in texts for match in _EXTENSION.finditer(text))
