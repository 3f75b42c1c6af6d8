"""Packages that are there with others: those of ROS's base images, and what a package depends on."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def base_holds(ros: int) -> frozenset[str]:
    """Return the ROS packages that the ``ros-base`` of every distribution of a ROS version has."""
    return frozenset(row["package"] for row in rows("base_holds") if row["ros"] == str(ros))


@cache
def carried_by(package: str, ubuntu: str | None, ros_distro: str | None) -> frozenset[str]:
    """Return what a package depends on; those of ROS are named without their distribution, ``ros-cv-bridge``.

    A row may hold for some Ubuntus or for some distributions of ROS ``only``.
    """
    fitting = (row for row in rows("carried") if row["package"] == package)
    return frozenset(
        name
        for row in fitting
        if not row["only"] or {ubuntu, ros_distro} & set(row["only"].split())
        for name in row["carries"].split()
    )
