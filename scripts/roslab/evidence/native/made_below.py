"""Libraries that a project links and that it makes itself, in its own file or in a folder that it adds or includes."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.evidence.cmake_project import CMakeProject
from roslab.values.dataclass import replace


def without_made(projects: Iterable[CMakeProject]) -> list[CMakeProject]:
    """Return the projects without their need of those libraries: nothing else has to bring them.

    Only what a usual build comes to counts. A library that is linked by the path of its file is another's.
    """
    found = list(projects)
    made = {(each.top, name) for each in found if each.usual for name in each.made}
    return [_without(each, frozenset(name for top, name in made if top == each.top)) for each in found]


def _without(project: CMakeProject, names: frozenset[str]) -> CMakeProject:
    kept = tuple(
        each
        for each in project.dependencies
        if each.namespace != "link" or each.strength == "declared" or each.name not in names
    )
    return project if len(kept) == len(project.dependencies) else replace(project, dependencies=kept)
