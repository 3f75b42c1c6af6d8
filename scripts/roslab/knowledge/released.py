"""Which ROS packages a distribution released, and which other keys rosdep has: for warnings, and to tell names apart.

rosdep and apt decide inside the image; this table only predicts what they will answer.
"""

from __future__ import annotations

from functools import cache

from roslab.knowledge.distros import distros
from roslab.knowledge.table import row, rows, whole


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
def _ever() -> str:
    """Return the text of the table without rosdep's own keys, a blank before and behind each name."""
    before, _, rest = whole("released").partition("\nrosdep,")
    return (before + rest.partition("\n")[2]).replace(",", " ")


@cache
def ever_released(package: str) -> bool:
    """Tell whether any distribution released a package of this name."""
    return f" {package} " in _ever()


@cache
def converting_packages() -> frozenset[str]:
    """Return the packages of ROS whose programs only write one file from another."""
    return frozenset(row["package"] for row in rows("converting_packages"))


@cache
def rosdep_keys() -> frozenset[str]:
    """Return the keys of rosdep's own tables that have a package for some Ubuntu."""
    return released("rosdep")
