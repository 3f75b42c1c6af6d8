"""The apt sources of ROS distributions, and the keys that sign them."""

from __future__ import annotations

from roslab.knowledge.distros import Distro
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class PackageSource:
    """An apt source: its address, and its key's name in ``keys.csv``."""

    url: str
    key: str


def ros_packages(release: Distro) -> PackageSource:
    """Return the apt source; for an ended distribution, whose tables are pinned, the last snapshot."""
    return last_snapshot(release) if release.rosdistro_tag else _source(release, f"ros{release.ros}")


def first_source(release: Distro) -> str:
    """Return the address that the packages of a distribution had while it was maintained."""
    return _source(release, f"ros{release.ros}").url


def last_snapshot(release: Distro) -> PackageSource:
    """Return the snapshot of a distribution as it was, or will be, at its end."""
    return _source(release, "ended")


def snapshot(release: Distro, day: str) -> PackageSource:
    """Return the snapshot of the sync of a day, ``YYYY-MM-DD``."""
    return _source(release, "dated", day)


def _source(release: Distro, which: str, day: str = "") -> PackageSource:
    row = next(row for row in rows("ros_packages") if row["which"] == which)
    return PackageSource(url=row["url"].format(name=release.name, day=day), key=row["key"])
