"""Headers of libraries that no table knows, that nothing names for the build, and that nothing is known to bring."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from roslab.decide.decision import Warning_
from roslab.decide.programs import owner, top_of
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import address, plain
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.required import similar
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.native.nowhere import LIBRARY
from roslab.knowledge.libraries import header, library
from roslab.knowledge.released import ever_released, rosdep_keys

_OF_GAZEBO = frozenset({"ignition", "gz", "sdf"})
"""Folders of headers that Gazebo brings: https://classic.gazebosim.org/tutorials?tut=plugins_hello_world."""
_SHORTEST = 3
"""Fewest letters of a name that a longer one may be called after."""


def without_library(
    evidence: Evidence, packages: Packages, provided: Collection[str], build_tool: str, *, unread: bool
) -> Iterator[tuple[str, Warning_]]:
    """Yield the file, with a warning, of each such header that a built package or the program includes.

    ``provided``: names in one spelling.

    What CMake, a manifest or a page names may bring the library, and what is called alike, its headers. So may what
    is ``unread``: a clone whose packages are not known, a command of roslab.yaml; and what lies in the package.
    """
    if unread:
        return
    headers = [each for each in evidence.code if each.namespace == "nowhere" and each.role == LIBRARY]
    folders = {m.file.rpartition("/")[0]: m.name for m in packages.built if m.name}
    if not evidence.manifests and (top := top_of(evidence)):
        folders = {top.file.rpartition("/")[0]: top.name or "the program"}
    told: set[str] = set()
    others = {*_with_others(evidence, folders)} if headers else set[str]()
    there = {*provided, *named(evidence)} if headers else set[str]()
    for each in headers:
        name = each.name.partition("/")[0]
        package = owner(each.file, folders)
        if package is None or package in others:
            continue
        of_gazebo = name in _OF_GAZEBO and similar("gazebo", there)
        if name not in told and not (of_gazebo or is_known(each, name) or may_bring(plain(name), there)):
            told.add(name)
            what = f"{package} includes {each.name}, and nothing is known that brings {name}"
            then = "give its package under `apt` or its repository under `source` in roslab.yaml"
            yield each.file, warn(f"{what}: {build_tool} will most likely stop there; {then}", each)


def _with_others(evidence: Evidence, folders: Mapping[str, str]) -> Iterator[str]:
    """Yield the packages in which a submodule lies or whose CMake fetches something."""
    submodules = (f"{git.name}/" for git in evidence.sources if git.kind == "submodule")
    fetching = (project.file for project in evidence.cmake if project.sources or project.brought)
    yield from (package for file in (*submodules, *fetching) if (package := owner(file, folders)))


def named(evidence: Evidence) -> Iterator[str]:
    """Yield what the tree names for its build, in one spelling."""
    asked: list[Dependency] = [d for each in evidence.cmake for d in each.dependencies]
    asked += [d for each in evidence.manifests for d in each.dependencies]
    asked += [*evidence.prose, *(d for each in evidence.dockerfiles for d in each.dependencies)]
    yield from (plain(each.name) for each in asked)
    yield from (plain(name) for each in evidence.sources for name in (each.name, address(each.url).rpartition("/")[2]))
    yield from (plain(each.name) for each in evidence.own_keys)
    for project in evidence.cmake:
        yield from (plain(name) for name in (*project.made, *project.brought))
    yield from (plain(each.name) for each in evidence.manifests if each.name)
    yield from (plain(each.key) for each in (*evidence.prose_pip, *evidence.listed))
    yield from (plain(each.key) for file in evidence.requirements for each in file.requirements)


def is_known(each: Dependency, name: str) -> bool:
    """Tell whether a table knows a header, or a library of its folder's name."""
    names = {name, name.lower(), f"lib{name.lower()}"}
    of_tables = any(library(naming, one, None) for naming in ("cmake", "link", "pkg-config") for one in names)
    return (
        bool(header(each.name, None)) or of_tables or any(ever_released(one) or one in rosdep_keys() for one in names)
    )


def may_bring(name: str, there: Collection[str]) -> bool:
    """Tell whether something there is called like a library, or as a part of its name is."""
    return similar(name, there) or any(len(each) >= _SHORTEST and similar(each, (name,)) for each in there)
