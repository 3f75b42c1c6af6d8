"""CMakeLists.txt without ``project()``: CMake calls it itself, or a macro of what is included does."""

from __future__ import annotations

from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.cmake import Call
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_WRAPPED = pattern(r"\n[ \t]*(\w{2,60})_project[ \t]*\(\s*([A-Za-z][\w.+-]{0,80})")


def stands_alone(name: str | None, *, makes: bool, minimum: bool, rosbuild: bool) -> bool:
    """Tell whether a file that no other adds is a project: CMake calls ``project()`` itself where it is missing.

    https://cmake.org/cmake/help/latest/command/project.html, read 2026-11-26. Macros of rosbuild call it.
    """
    return name is not None or (makes and minimum and not rosbuild)


def wrapped(include: Call, path: str, text: str, repository: Repository) -> tuple[str, Dependency] | None:
    """Return the name that a macro of an included module gives the project, and the module that the build needs.

    It is ``include(ReMake)`` with ``remake_project(NAME …)``, where no file of the tree has that module.
    """
    module = include.words[0] if include.words else ""
    if include.conditions or "_project" not in text or repository.named(f"{module}.cmake"):
        return None
    for match in _WRAPPED.finditer(f"\n{text}"):
        if match[1].lower() == module.lower():
            needs = Dependency(
                namespace="cmake", name=module, strength="declared", file=path, line=include.line, required=True
            )
            return match[2], needs
    return None
