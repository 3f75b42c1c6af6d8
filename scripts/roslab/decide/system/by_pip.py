"""Packages of ROS that code imports and that pip brings: two builds of one library in a process end it.

/opt/ros comes before pip's folder on PYTHONPATH and LD_LIBRARY_PATH.
https://github.com/stack-of-tasks/pinocchio/issues/2230, 2026-11-26
"""

from __future__ import annotations

from collections.abc import Iterable

from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import imports
from roslab.knowledge.often_brought import brought_modules
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement


def imported_from_pip(evidence: Evidence, installed: Iterable[Requirement]) -> frozenset[tuple[str, str, int]]:
    """Return the imports, by module, file and line, of what is ``installed`` by pip, or by what that needs."""
    names = {each.key for each in installed if each.name and each.origin != "import"}
    return frozenset(
        (used.name, used.file, used.line)
        for used in evidence.code
        if used.namespace == "import" and names and _brings(used.name, names)
    )


def only_imported(asked: Dependency, found: frozenset[tuple[str, str, int]]) -> bool:
    """Tell whether a package of ROS is asked for by one of these imports."""
    return asked.namespace == "ros" and (asked.name, asked.file, asked.line) in found


def _brings(module: str, names: set[str]) -> bool:
    package, _ = imports().get(module, (None, None))
    return bool(package and canonicalize_name(package) in names) or bool(brought_modules().get(module, set()) & names)
