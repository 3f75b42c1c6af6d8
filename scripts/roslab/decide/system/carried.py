"""Packages that need no naming: the base has them, or another package that is installed brings them."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.system.names import Target
from roslab.knowledge.carried import base_holds, carried_by
from roslab.knowledge.distros import distros


def held(target: Target, variant: str) -> frozenset[str]:
    """Return the apt names of the ROS packages that the base of a variant of ROS, ``ros-base`` if empty, has."""
    if target.ros_distro is None or variant == "ros-core":
        return frozenset()
    ros = distros()[target.ros_distro]
    return frozenset(target.ros(name) for name in (*base_holds(ros.ros), *filter(None, (ros.middleware,))))


def brought(installed: Iterable[str], target: Target, *, directly: bool = False) -> frozenset[str]:
    """Return the apt names that packages, given by theirs, depend on, ``directly`` or also through others."""
    prefix = f"ros-{target.ros_distro}-"
    found: set[str] = set()
    open_ = list(installed)
    while open_:
        package = open_.pop()
        name = f"ros-{package.removeprefix(prefix)}" if package.startswith(prefix) else package
        carried = carried_by(name, target.ubuntu, target.ros_distro)
        new = {f"{prefix}{each[4:]}" if each.startswith("ros-") else each for each in carried} - found
        found |= new
        open_ += () if directly else new
    return frozenset(found)
