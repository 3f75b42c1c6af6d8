"""What a build script of Python compiles, and by which of its commands."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.python.needs_gpu import needs_gpu
from roslab.values.pattern import pattern

_BUILDING = frozenset({"build", "build_ext", "build_py", "build_clib", "develop", "editable_wheel"})
"""Commands that an editable installation runs."""
_BUILDS = pattern(r"[\"'](?:cmake|make|ninja|scons|bazel)(?:[\"']|\s(?!sure))")
"""A program that compiles, as the first word of a command."""


def extensions(text: str) -> tuple[str, ...]:
    """Return what kinds of code a build script compiles, by the names it uses."""
    found = []
    if re.search(r"CUDAExtension|\bnvcc\b|\.cu['\"]", text):
        found.append("cuda")
    if re.search(r"CppExtension|\bExtension\s*\(|Pybind11Extension|pybind11", text):
        found.append("c")
    if re.search(r"cythonize|[Cc]ython", text):
        found.append("cython")
    if re.search(r"CMakeExtension|CMakeBuild|skbuild|scikit_build|['\"]cmake['\"]", text):
        found.append("cmake")
    if needs_gpu(text):
        found.append("gpu")
    if re.search(r"\bdisable_editable\s*=\s*True\b", text):
        found.append("not editable")
    return tuple(found)


def by_install(text: str, commands: tuple[str, ...]) -> Iterator[str]:
    """Yield how its own ``install`` is called where that alone compiles: an editable installation never runs it.

    https://setuptools.pypa.io/en/latest/userguide/extension.html#adding-commands, read 2026-11-26.
    """
    if "install" in commands and _BUILDING.isdisjoint(commands) and _BUILDS.search(text):
        yield "by install of setuptools" if "setuptools.command.install" in text else "by install"
