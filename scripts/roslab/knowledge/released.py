"""Which ROS packages a distribution released, and which other keys rosdep has: for warnings, and to tell names apart.

rosdep and apt decide inside the image; this table only predicts what they will answer.
"""

from __future__ import annotations

from functools import cache

from roslab.knowledge.distros import distros
from roslab.knowledge.table import path_of, row, rows, whole
from roslab.values.kept_file import KeptFile


@cache
def released(distro: str) -> frozenset[str]:
    """Return the names of the packages that a distribution released, an empty set for an unknown one.

    A short-lived or very new one without a row of its own has those of the distribution before it.
    """
    if found := row("released", distro):
        return frozenset(found["packages"].split())
    this = distros().get(distro)
    older = [d for d in distros().values() if this and d.ros == this.ros and d.released < this.released]
    return released(max(older, key=lambda d: d.released).name) if older else frozenset()


@cache
def _ever_released() -> frozenset[str]:
    """Return the words of the table without those of rosdep's row: the names of packages, and few others."""
    found: frozenset[str] = KeptFile(__spec__, "words").value(path_of("released"), _words)
    return found


def _words(_: str) -> frozenset[str]:
    before, _, rest = whole("released").partition("\nrosdep,")
    return frozenset((before + rest.partition("\n")[2]).replace(",", " ").split(" "))


def ever_released(package: str) -> bool:
    """Tell whether any distribution released a package of this name."""
    return package in _ever_released()


def released_for(package: str, ros: int) -> bool:
    """Tell whether any distribution of ROS 1 or 2 released a package of this name."""
    return ever_released(package) and any(
        package in released(each.name) for each in distros().values() if each.ros == ros
    )


@cache
def converting_packages() -> frozenset[str]:
    """Return the packages of ROS whose programs only write one file from another."""
    return frozenset(row["package"] for row in rows("converting_packages"))


@cache
def rosdep_keys() -> frozenset[str]:
    """Return the keys of rosdep's own tables that have a package for some Ubuntu."""
    return released("rosdep")
