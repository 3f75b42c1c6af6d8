"""The versions that each distribution has of some packages: rclpy, controller_manager, moveit_core."""

from __future__ import annotations

from functools import cache

from packaging.version import Version

from roslab.knowledge.distros import distros
from roslab.knowledge.table import rows


@cache
def versions(name: str) -> dict[str, Version]:
    """Return the last version of a package in each distribution that has it, by the distribution; of most, none."""
    return {distro: of[key] for distro, of in _by_distro().items() if (key := name.replace("-", "_").lower()) in of}


@cache
def _by_distro() -> dict[str, dict[str, Version]]:
    read = ((row["distro"], (each.partition("=") for each in row["versions"].split())) for row in rows("ros_versions"))
    return {distro: {name: Version(version) for name, _, version in found} for distro, found in read}


def with_version(name: str, version: Version, ros: int) -> frozenset[str]:
    """Return the distributions of a ROS version that have, or once had, a version of a package.

    Those with the same first two numbers, else the first with a newer one: each got all versions after the older one's.
    """
    known = {each: found for each, found in versions(name).items() if distros()[each].ros == ros}
    same = {each for each, found in known.items() if found.release[:2] == version.release[:2]}
    later = (each for each, found in known.items() if found > version and not distros()[each].never_ends)
    return frozenset(same or sorted(later, key=lambda each: distros()[each].released)[:1])
