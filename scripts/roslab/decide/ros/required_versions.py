"""Distributions whose packages are older than CMake asks for: ``find_package(controller_manager 4.0.0)``."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.ros.workspace import packages_of
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import distros
from roslab.knowledge.ros_versions import repositories_of, versions
from roslab.values.version import Version


def with_older(evidence: Evidence, ros: int) -> dict[str, frozenset[str]]:
    """Return, for each distribution of a ROS version, the packages of which it has an older version than is asked for.

    A file that asks for a version without ``REQUIRED`` stops by itself, or does without what it was written for. What
    none of them has speaks against none, nor does a package that the tree has or whose repository is cloned.
    """
    older: dict[str, frozenset[str]] = {}
    for each in _asked(evidence):
        known = {name: found for name, found in versions(each.name).items() if distros()[name].ros == ros}
        without = {name for name, found in known.items() if found < Version(each.version or "0")}
        for name in without if len(without) < len(known) else ():
            older[name] = older.get(name, frozenset()) | {f"{each.name} {each.version} ({each.file}:{each.line})"}
    return older


def _asked(evidence: Evidence) -> Iterator[Dependency]:
    packages = packages_of(evidence)
    folders = {manifest.file.rpartition("/")[0] for manifest in packages.built}
    here = {git.name.rpartition("/")[2] for git in evidence.sources if git.kind != "link"} | packages.names
    for project in evidence.cmake:
        for each in project.dependencies if project.file.rpartition("/")[0] in folders else ():
            certain = each.namespace == "cmake" and each.strength != "optional" and each.role != "test"
            if certain and each.version and here.isdisjoint({each.name, *repositories_of(each.name)}):
                yield each
