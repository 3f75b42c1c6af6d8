"""Worlds of the tree that a page starts in Gazebo: ``gz sim``, ``ign gazebo``, ``gazebo``."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.facts import Evidence
from roslab.evidence.prose.runners import SIMULATORS
from roslab.values.pattern import pattern

_BRINGS = {
    "gz": pattern(r"(?:ros_)?gz(?:_sim\w*)?|gz-sim\d*|ros_gz_\w+|gz_ros2_control"),
    "ign": pattern(r"ros_(?:gz|ign)(?:_\w+)?|(?:ignition|ign)[-_]gazebo\d*|(?:gz|ign)_ros2_control"),
    "gazebo": pattern(r"gazebo(?:_ros(?:_\w+)?|_dev|\d+|)"),
}
"""Packages that bring each program. https://github.com/gazebosim/ros_gz (table of versions), 2026-11-23"""


def simulators_of(evidence: Evidence) -> frozenset[str]:
    """Return the programs of Gazebo that what the packages ask for brings."""
    asked = frozenset(_asked(evidence))
    return frozenset(name for name in SIMULATORS if any(map(_BRINGS[name].fullmatch, asked)))


def _asked(evidence: Evidence) -> Iterator[str]:
    for manifest in evidence.manifests:
        yield from (each.name for each in manifest.dependencies if each.role not in {"test", "doc"})
    for project in evidence.cmake:
        yield from (each.name for each in project.dependencies if each.strength == "declared")
    for launch in evidence.launch:
        yield from (each.name for each in launch.dependencies)
