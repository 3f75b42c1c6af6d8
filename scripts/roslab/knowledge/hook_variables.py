"""The variables that a package of ROS sets by a hook of the setup script, which the shells of the image source."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.knowledge.table import rows


def set_by_hooks(packages: Iterable[str]) -> frozenset[str]:
    """Return the names of the variables that are set where these are; a row also names what depends on its package."""
    there = frozenset(packages)
    found = (row["variables"].split() for row in rows("hook_variables") if there & {*row["packages"].split()})
    return frozenset(name for names in found for name in names)
