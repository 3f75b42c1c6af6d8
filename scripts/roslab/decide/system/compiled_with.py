"""Libraries that a build surely needs although no ``find_package`` asks for them: linked by name, and included."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.system.names import Target, resolve
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence

_NOT_LOOKED_UP = frozenset({"trusty"})
"""Ubuntus that packages.ubuntu.com, from which the tables were written, has no more: packages are only tried there."""


def compiled_with(
    needed: Iterable[tuple[Dependency, bool]], evidence: Evidence, target: Target
) -> dict[str, Dependency | None]:
    """Return the packages of Ubuntu that hold both a library that is always linked and a header that code includes.

    ``needed``: names, each with whether the build really uses the file that names it.
    """
    if target.ubuntu in _NOT_LOOKED_UP:
        return {}
    code = (d for d in evidence.code if d.namespace == "include" and d.strength == "used" and not places.aside(d.file))
    headers = {apt for each in code for apt in resolve(each, target).apt}
    found: dict[str, Dependency | None] = {}
    for asked, trusted in needed:
        if trusted and asked.namespace == "link" and asked.strength == "used":
            ours = (apt for apt in resolve(asked, target).apt if apt in headers and not apt.startswith("ros-"))
            found.update((apt, asked) for apt in ours if apt not in found)
    return found
