"""What apt brings in place of a repository that a page clones: packages of its name that are released."""

from __future__ import annotations

from roslab.decide.ros.source_names import plain
from roslab.decide.system.gazebo import of_release
from roslab.decide.system.packages import SystemPackages
from roslab.knowledge.released import ever_released

_MANY = "_pkgs"
"""The usual end of the name of a repository with several packages."""


def in_place(repository: str, system: SystemPackages) -> tuple[str, ...]:
    """Return the released packages of the image that are called like a repository, or begin with its name."""
    name = plain(repository).removesuffix(_MANY)
    keys = (key for key in system.rosdep if key == name or key.startswith(f"{name}_"))
    return (*of_release(name, system.installed), *sorted(key for key in keys if ever_released(key)))
