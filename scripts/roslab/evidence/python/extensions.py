"""What a build script of Python compiles, and by which of its commands."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.values.pattern import pattern

_BUILDING = frozenset({"build", "build_ext", "build_py", "build_clib", "develop", "editable_wheel"})
"""Commands that an editable installation runs."""
_BUILDS = pattern(r"[\"'](?:cmake|make|ninja|scons|bazel)(?:[\"']|\s(?!sure))")
"""A program that compiles, as the first word of a command."""
_KINDS = (
    ("cuda", pattern(r"CUDAExtension|\bnvcc\b|\.cu['\"]")),
    ("c", pattern(r"CppExtension|\bExtension\s*\(|Pybind11Extension|pybind11")),
    ("cython", pattern(r"cythonize|[Cc]ython")),
    ("cmake", pattern(r"CMakeExtension|CMakeBuild|skbuild|scikit_build|['\"]cmake['\"]")),
)
_COMMENTS = pattern(r"^[ \t]*#[^\n]*", re.MULTILINE)
_NOT_EDITABLE = pattern(r"\bdisable_editable\s*=\s*True\b")


def extensions(text: str) -> tuple[str, ...]:
    """Return what kinds of code a build script compiles, by the names it uses; not in lines that are a comment."""
    code = _COMMENTS.sub("", text) if "#" in text else text
    found = [kind for kind, names in _KINDS if names.search(code)]
    if "cuda.is_available()" in code:
        from roslab.evidence.python.needs_gpu import needs_gpu, only_asks  # noqa: PLC0415 - with Python's own parser

        if needs_gpu(code):
            found.append("gpu asked" if only_asks(code) else "gpu")
    if _NOT_EDITABLE.search(code):
        found.append("not editable")
    return tuple(found)


def by_install(text: str, commands: tuple[str, ...]) -> Iterator[str]:
    """Yield how its own ``install`` is called where that alone compiles: an editable installation never runs it.

    https://setuptools.pypa.io/en/latest/userguide/extension.html#adding-commands, read 2026-11-26.
    """
    if "install" in commands and _BUILDING.isdisjoint(commands) and _BUILDS.search(text):
        yield "by install of setuptools" if "setuptools.command.install" in text else "by install"
