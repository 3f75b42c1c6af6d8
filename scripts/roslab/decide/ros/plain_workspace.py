"""Packages of plain CMake that lie beside each other, which only colcon builds together."""

from __future__ import annotations

from roslab.decide.ros.workspace import packages_of
from roslab.evidence.facts import Evidence, Mention

FEWEST = 2
"""A single package is built by CMake alone."""


def built_together(evidence: Evidence) -> Mention | None:
    """Return where a page runs colcon on several packages without a CMakeLists.txt above them, else ``None``."""
    said = (m for m in evidence.mentions if m.topic == "build_tool" and m.value == "colcon" and m.source == "readme")
    apart = [manifest for manifest in packages_of(evidence).built if "/" in manifest.file]
    if len(apart) < FEWEST or any(project.file == "CMakeLists.txt" for project in evidence.cmake):
        return None
    return next(said, None)
