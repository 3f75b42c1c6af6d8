"""Packages of Debian that the repository itself holds, and what the code cannot be compiled without of them."""

from __future__ import annotations

import posixpath

from roslab.config.model import Config
from roslab.decide.ros.by_page import packages_of
from roslab.evidence.facts import Evidence
from roslab.evidence.prose.own_packages import NAME
from roslab.evidence.x86_only import X86Only
from roslab.values.pattern import pattern

_PLAIN = pattern(r"[\w./+~-]+")
"""A path that a mount of a Dockerfile, whose options commas part, can name."""


def own_packages(evidence: Evidence, config: Config) -> tuple[str, ...]:
    """Return their paths in the order in which they are installed, of several with one name the first."""
    if config.compatible:
        return ()
    paths = (each.value for each in evidence.mentions if each.topic == "own_package" and _PLAIN.fullmatch(each.value))
    found: dict[str, str] = {}
    for path in paths:
        found.setdefault(posixpath.basename(path), path)
    return tuple(found.values())


def for_x86_alone(evidence: Evidence) -> X86Only | None:
    """Return the first for amd64 alone with the name of what CMake requires."""
    asked = [each for project in evidence.cmake for each in project.dependencies if each.strength == "declared"]
    paths = [each.value for each in evidence.mentions if each.topic == "own_package"]
    for_arm = {_package(path) for path in paths if path.endswith(("_arm64.deb", "_all.deb"))}
    for path in paths:
        name = _package(path)
        if path.endswith("_amd64.deb") and name not in for_arm:
            for each in asked:
                if name in packages_of(each.name.lower()):
                    return X86Only(path, "binary", each.file, each.line)
    return None


def _package(path: str) -> str:
    name = NAME.fullmatch(posixpath.basename(path))
    return name[1] if name else ""
