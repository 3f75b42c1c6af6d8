"""Libraries of Gazebo that ROS packages itself, where pages install those of Gazebo's own archive.

A workspace finds ROS's first, and parts of both are not made for each other:
https://gazebosim.org/docs/harmonic/ros_installation/ (Gazebo from the ROS repositories), 2026-11-28.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TypeVar

from roslab.decide.ros.misnamed import library_called
from roslab.decide.system.names import Target
from roslab.evidence.dependency import Dependency
from roslab.values.pattern import pattern

_OF_APT = pattern(r"lib(gz-[a-z-]{2,30}?\d{1,2})-dev")
Asked = TypeVar("Asked")


def without_vendored(keys: Iterable[Dependency], target: Target) -> tuple[Dependency, ...]:
    """Return the keys without the names of such libraries, which come from ROS whatever pages install."""
    return tuple(key for key in keys if not _vendor(key.name, target))


def with_vendors(packages: Mapping[str, Asked], target: Target) -> dict[str, Asked]:
    """Return packages of apt, each with who asked for it, with ROS's in place of those of Gazebo's archive."""
    found: dict[str, Asked] = {}
    for name, asked in packages.items():
        called = _OF_APT.fullmatch(name)
        found.setdefault((_vendor(called[1], target) if called else "") or name, asked)
    return found


def _vendor(name: str, target: Target) -> str:
    library = library_called(name, target.ubuntu) if name.startswith("gz-") and target.ros_distro else None
    vendor = library.ros if library else None
    return target.ros(vendor) if vendor and vendor.endswith("_vendor") and target.knows(vendor) else ""
