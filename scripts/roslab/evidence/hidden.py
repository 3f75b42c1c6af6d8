"""Folders with a marker that hides them, and all below them, from the build tools of ROS."""

from __future__ import annotations

from roslab.repository.checkout import Repository

IGNORE_MARKERS = ("COLCON_IGNORE", "AMENT_IGNORE", "CATKIN_IGNORE")
"""Markers that keep a folder from being a package: catkin_pkg and colcon-ros obey all three."""


def hidden(repository: Repository, folder: str) -> bool:
    """Tell whether a folder has such a marker, or one above it."""
    marked = repository.once(_marked)
    return bool(marked) and ("" in marked or f"{folder}/".startswith(tuple(f"{each}/" for each in marked)))


def _marked(repository: Repository) -> frozenset[str]:
    return frozenset(file.folder for file in repository.named(*IGNORE_MARKERS))
