"""Keys of package.xml files for what needs no package: it is made here, or every Python has it."""

from __future__ import annotations

import sys
from collections.abc import Collection, Iterable, Iterator

from roslab.decide.ros.own_configs import installing, linked_of_tree
from roslab.decide.ros.source_names import plain
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.released import ever_released, rosdep_keys
from roslab.knowledge.standard_modules import standard_modules


def own_targets(keys: Iterable[Dependency], evidence: Evidence) -> tuple[str, ...]:
    """Return the keys that are libraries or programs of their own package's CMake, or installed by another's.

    A program may be called like a package that is released, that a page names, or that CMake looks for or the code
    includes: a node is often called like the driver that it wraps. What another project installs has no package.xml.
    A package of Python may name modules of Python's own library: ``json``.
    """
    here, linked = installing(evidence), linked_of_tree(evidence)
    named = {plain(git.name) for git in evidence.sources}
    named |= {plain(each.name.partition("/")[0]) for each in evidence.code if each.namespace == "include"}
    folders = {manifest.file.rpartition("/")[0] for manifest in evidence.manifests}
    made: dict[str, set[str | None]] = {}
    for project in evidence.cmake:
        for name in (*project.made, *_programs(project, named)):
            made.setdefault(name, set()).add(places.innermost(project.file, folders))
    python = {project.folder for project in evidence.python}
    return tuple(
        key.name
        for key in keys
        if key.name.lower() in here
        or (key.name in linked and not ever_released(key.name) and key.name not in rosdep_keys())
        or (key.file.rpartition("/")[0] in python and _of_python(key.name))
        or key.file.rpartition("/")[0] in made.get(key.name, ())
    )


def _programs(project: CMakeProject, named: Collection[str]) -> Iterator[str]:
    names = (path.rpartition("/")[2] for path, _ in project.executables)
    sought = {plain(each.name) for each in project.dependencies if each.namespace == "cmake"}
    return (name for name in names if plain(name) not in {*named, *sought} and not ever_released(name))


def _of_python(name: str) -> bool:
    known = name in rosdep_keys() or ever_released(name)
    return not known and (name in sys.stdlib_module_names or name in standard_modules())
