"""Keys of a package.xml that pip brings, unless the package's code of C++ is compiled with what is called so."""

from __future__ import annotations

from collections.abc import Collection

from roslab.decide.ros.misnamed import of_installed
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence


def brought_by_pip(key: Dependency, installed: Collection[str], evidence: Evidence) -> str:
    """Return the name of what pip installs that a key means, ``""`` where it is none of it.

    ``installed``: names in pip's plain spelling.
    """
    found = of_installed(key.name, installed)
    return "" if found and _of_library(key, evidence) else found


def of_code(key: Dependency, evidence: Evidence) -> bool:
    """Tell whether CMake of the key's package asks for it by its name, or the package's code includes its headers."""
    folder = key.file.rpartition("/")[0]
    cmake = f"{folder}/CMakeLists.txt".lstrip("/")
    if any(d.name == key.name for project in evidence.cmake if project.file == cmake for d in project.dependencies):
        return True
    included = (d for d in evidence.code if d.namespace == "include" and d.name.startswith(f"{key.name}/"))
    return any(not folder or d.file.startswith(f"{folder}/") for d in included)


def _of_library(key: Dependency, evidence: Evidence) -> bool:
    """Tell whether the key's package is compiled with what is called so, in whatever letters: pip has no such thing."""
    name = key.name.lower()
    named = (d.name for project in evidence.cmake for d in project.dependencies)
    return any(each.lower() == name for each in named) or of_code(key, evidence)
