"""What projects of CMake add, over as many files that add others as there are."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable

from roslab.evidence.cmake_project import CMakeProject
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Added:
    """The files that a build reads."""

    projects: tuple[CMakeProject, ...]
    """Those that it begins with, and all that they add by names which are written out."""
    unknown: tuple[str, ...]
    """How the paths of others begin, whose ends variables tell."""


def added_by(built: Iterable[CMakeProject], projects: Iterable[CMakeProject], *, usual: bool = False) -> Added:
    """Follow what projects add; ``usual``: only where a usual build adds it, by no option that is off."""
    by_folder = {folder_of(project): project for project in projects}
    found: dict[str, CMakeProject] = {}
    unknown: dict[str, None] = {}
    left = list(built)
    while left:
        project = left.pop()
        if project.file in found:
            continue
        found[project.file] = project
        for folder in project.adds:
            if "$" in folder:
                unknown[folder.partition("$")[0]] = None
            elif (part := by_folder.get(posixpath.normpath(folder))) is not None and (part.usual or not usual):
                left.append(part)
    return Added(projects=tuple(found.values()), unknown=tuple(unknown))


def folder_of(project: CMakeProject) -> str:
    """Return the folder of a project, ``""`` for the root."""
    return project.file.rpartition("/")[0]
