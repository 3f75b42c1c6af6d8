"""Projects of CMake in the tree that another one links by a bare name: they are installed before it."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.programs import top_of
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence


def linked_projects(evidence: Evidence) -> Iterator[tuple[CMakeProject, Dependency]]:
    """Yield each project that the one which is built links and does not add, with the first call that names it.

    Such a project installs itself for find_package, as is asked of no copy that its own script compiles in place. What
    a part of the built project makes itself is none.
    """
    top = top_of(evidence)
    root = top.file.rpartition("/")[0] if top else ""
    parts = [p for p in evidence.cmake if p is top or (p.added and f"{p.file}/".startswith(f"{root}/".lstrip("/")))]
    made = {name for part in parts for name in part.made}
    links = [each for part in parts for each in part.dependencies if each.namespace == "link" and each.role == "build"]
    linked = {each.name: each for each in reversed(links) if each.strength == "used" and each.name not in made}
    for project in evidence.cmake:
        own = project.top_level and not project.added and project is not top and not project.lacks
        asked = next((linked[name] for name in project.made if name in linked), None)
        if own and asked and project.configs and not (places.test(project.file) or places.example(project.file)):
            yield project, asked
