"""Which ROS packages a distribution released, and which other keys rosdep knows: for warnings, to tell names apart.

The truth is in the image, where rosdep and apt answer; this table only says beforehand what they will probably say.
"""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows

_AS = {"jade": "indigo", "lunar": "kinetic"}
"""Short-lived distributions whose packages are those of their neighbour."""


@cache
def released(distro: str) -> frozenset[str]:
    """Return the names of the packages that a distribution released, an empty set for an unknown one."""
    wanted = _AS.get(distro, distro)
    return next(
        (frozenset(row["packages"].split()) for row in rows("released") if row["distro"] == wanted), frozenset()
    )


@cache
def rosdep_keys() -> frozenset[str]:
    """Return the keys of rosdep's own tables that hold a package for some Ubuntu."""
    return released("rosdep")
