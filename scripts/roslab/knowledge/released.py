"""Which ROS packages a distribution released, and which other keys rosdep knows: for warnings, to tell names apart.

The truth is in the image, where rosdep and apt answer; this table only says beforehand what they will probably say.
"""

from __future__ import annotations

from functools import cache

from roslab.knowledge.distros import distros
from roslab.knowledge.table import rows


@cache
def released(distro: str) -> frozenset[str]:
    """Return the names of the packages that a distribution released, an empty set for an unknown one.

    One without a row of its own, short-lived or quite new, has those of the distribution before it.
    """
    known = {row["distro"]: row["packages"] for row in rows("released")}
    this = distros().get(distro)
    if distro in known or this is None:
        return frozenset(known.get(distro, "").split())
    older = [d for d in distros().values() if d.ros == this.ros and d.released < this.released and d.name in known]
    return released(max(older, key=lambda d: d.released).name) if older else frozenset()


@cache
def rosdep_keys() -> frozenset[str]:
    """Return the keys of rosdep's own tables that hold a package for some Ubuntu."""
    return released("rosdep")
