"""Which ROS packages a distribution released, and which other keys rosdep has: for warnings, and to tell names apart.

rosdep and apt decide inside the image; this table only predicts what they will answer.
"""

from __future__ import annotations

from functools import cache

from roslab.knowledge.distros import distros
from roslab.knowledge.table import rows


@cache
def released(distro: str) -> frozenset[str]:
    """Return the names of the packages that a distribution released, an empty set for an unknown one.

    A short-lived or very new one without a row of its own has those of the distribution before it.
    """
    known = {row["distro"]: row["packages"] for row in rows("released")}
    this = distros().get(distro)
    if distro in known or this is None:
        return frozenset(known.get(distro, "").split())
    older = [d for d in distros().values() if d.ros == this.ros and d.released < this.released and d.name in known]
    return released(max(older, key=lambda d: d.released).name) if older else frozenset()


@cache
def rosdep_keys() -> frozenset[str]:
    """Return the keys of rosdep's own tables that have a package for some Ubuntu."""
    return released("rosdep")
