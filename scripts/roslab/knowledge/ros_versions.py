"""The versions that each distribution has of some packages: rclpy, controller_manager, moveit_core."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.distros import distros
from roslab.knowledge.table import rows
from roslab.values.version import Version


@cache
def versions(name: str) -> dict[str, Version]:
    """Return the last version of a package in each distribution that has it, by the distribution; of most, none."""
    key = name.replace("-", "_").lower()
    return {distro: of[key][1] for distro, of in _by_distro().items() if key in of}


def repositories_of(name: str) -> frozenset[str]:
    """Return the names of the repositories that such a package is released from."""
    return frozenset(of[name][0] for of in _by_distro().values() if name in of)


@cache
def _by_distro() -> dict[str, dict[str, tuple[str, Version]]]:
    return {row["distro"]: dict(_read(each) for each in row["versions"].split()) for row in rows("ros_versions")}


def _read(written: str) -> tuple[str, tuple[str, Version]]:
    """Return what ``REPOSITORY/NAME=VERSION`` says."""
    path, _, version = written.partition("=")
    repository, _, name = path.partition("/")
    return name, (repository, Version(version))


def with_version(name: str, version: Version, ros: int) -> frozenset[str]:
    """Return the distributions of a ROS version that have, or once had, a version of a package.

    Those with the same first two numbers, else the first with a newer one: each got all versions after the older one's.
    """
    known = {each: found for each, found in versions(name).items() if distros()[each].ros == ros}
    same = {each for each, found in known.items() if found.release[:2] == version.release[:2]}
    later = (each for each, found in known.items() if found > version and not distros()[each].never_ends)
    return frozenset(same or sorted(later, key=lambda each: distros()[each].released)[:1])
