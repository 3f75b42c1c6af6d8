"""Packages of the tree that nothing can build although others of it need them built: somebody else has them whole."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import PackageManifest


def unbuildable(
    assets: Iterable[PackageManifest], built: Collection[PackageManifest], projects: Iterable[CMakeProject]
) -> frozenset[str]:
    """Return the names of ``assets`` without a CMakeLists.txt that CMake of packages which are built requires.

    A package.xml alone, as it is left where git ignores the CMakeLists.txt of a copy, brings nothing to link.
    """
    projects = tuple(projects)
    there = {project.file.rpartition("/")[0] for project in projects}
    bare = {m.name for m in assets if m.name and not m.metapackage and m.file.rpartition("/")[0] not in there}
    if not bare:
        return frozenset()
    folders = tuple(m.file.rpartition("/")[0] for m in built)
    asked = {
        dependency.name
        for project in projects
        if any(not folder or project.file.startswith(f"{folder}/") for folder in folders)
        for dependency in project.dependencies
        if dependency.namespace == "ros" and dependency.strength == "declared"
    }
    return frozenset(bare & asked)
