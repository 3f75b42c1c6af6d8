"""Projects of CMake in the tree that need the library of the one which is built: they are compiled after it.

The author's own calls tell which: examples that nobody builds may be for other machines.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention

MOST = 8
"""Most of them that are compiled."""


def linking(evidence: Evidence, top: CMakeProject | None) -> tuple[tuple[CMakeProject, Dependency], ...]:
    """Return each project that links a library of ``top``, or finds its package, with the first call that names it.

    Those that a page, a script beside them or CI compiles, or of which a page runs a program.
    """
    return tuple(_linking(evidence, top))[:MOST] if top else ()


def _linking(evidence: Evidence, top: CMakeProject) -> Iterator[tuple[CMakeProject, Dependency]]:
    root = top.file.rpartition("/")[0]
    parts = [p for p in evidence.cmake if p is top or (p.added and f"{p.file}/".startswith(f"{root}/".lstrip("/")))]
    libraries, packages = {name for p in parts for name in p.made}, {name for p in parts for name in p.configs}
    for project in evidence.cmake if libraries or packages else ():
        aside = places.vendored(project.file) or places.test(project.file) or places.documentation(project.file)
        if not project.top_level or project.added or project is top or project.lacks or aside or not project.name:
            continue
        below = [project, *(p for p in evidence.cmake if p.added and p.top == project.file.rpartition("/")[0])]
        made = {name for each in below for name in each.made}
        asked = (asked for each in below for asked in each.dependencies if asked.name not in made)
        wanted = (each for each in asked if each.name in (packages if each.namespace == "cmake" else libraries))
        first = next(wanted, None)
        if first and _built(project, [name for each in below for name, _ in each.executables], evidence):
            yield project, first


def _built(project: CMakeProject, programs: list[str], evidence: Evidence) -> bool:
    folder = project.file.rpartition("/")[0]
    return any(_compiles(said, folder) or _runs(said, programs) for said in evidence.mentions)


def _compiles(said: Mention, folder: str) -> bool:
    """Tell whether a text has CMake compile a folder, or runs a script that lies there."""
    if said.topic == "build_script":
        place = posixpath.dirname(posixpath.join(*said.value.split()[:2]))
    elif said.topic == "compiled":
        place = posixpath.join(posixpath.dirname(said.file) if said.source == "script" else "", said.value)
    else:
        return False
    return f"/{posixpath.normpath(place)}".endswith(f"/{folder}")


def _runs(said: Mention, programs: list[str]) -> bool:
    by_page = said.topic == "command" and said.source == "readme"
    return by_page and posixpath.basename(said.value.split(" ")[0]) in programs
