"""Modules that the tree's own build compiles: no file of Python has their name."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.knowledge.frameworks import imports as known_imports
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

_EXTENSION = pattern(r"\b\w*Extension\s*\(\s*(?:name\s*=\s*)?[\"']([A-Za-z_][\w.]*)[\"']")
"""``Extension``, and those of PyTorch and pybind11;
https://setuptools.pypa.io/en/latest/userguide/ext_modules.html, read 2026-11-27."""
_TARGET = pattern(
    r"\b(?:pybind11_add_module|nanobind_add_module|python_add_library|python3_add_library|python_add_module)"
    r"\s*\(\s*\"?(?:([A-Za-z_]\w*)|\$\{(?:CMAKE_)?PROJECT_NAME\})",
    re.IGNORECASE,
)
"""https://pybind11.readthedocs.io/en/stable/compiling.html, https://nanobind.readthedocs.io/en/latest/api_cmake.html,
https://cmake.org/cmake/help/latest/module/FindPython.html, read 2026-11-27."""
_PROJECT = pattern(r"\bproject\s*\(\s*([A-Za-z_]\w*)", re.IGNORECASE)

MOST = 300
"""Files of CMake that are read, the nearest to the root first."""


def compiled_modules(repository: Repository) -> frozenset[str]:
    """Return the names by which a program imports what setup.py or CMake compiles: ``a`` for ``a._C``.

    What copied code compiles under the name of a known package may not be compiled here: the package brings it.
    """
    found = (*_of_setup(repository), *_of_cmake(repository))
    return frozenset(name for name, path in found if name not in known_imports() or not places.vendored(path))


def _of_setup(repository: Repository) -> Iterator[tuple[str, str]]:
    for file in repository.named("setup.py"):
        text = repository.read(file)
        if "Extension" in text and not places.test(file.path):
            yield from ((match[1].partition(".")[0], file.path) for match in _EXTENSION.finditer(text))


def _of_cmake(repository: Repository) -> Iterator[tuple[str, str]]:
    for file in nearest(repository.named("CMakeLists.txt"))[:MOST]:
        text = repository.read(file)
        for match in _TARGET.finditer(text) if "_add_" in text and not places.test(file.path) else ():
            project = _PROJECT.search(text)
            if name := match[1] or (project[1] if project else ""):
                yield name, file.path
