"""Keys of a package.xml that are no packages of ROS by their name: pip's names, and the build type of a package.

https://docs.ros.org/en/independent/api/rosdep/html/rosdep_yaml_format.html, 2026-11-26
"""

from __future__ import annotations

from collections.abc import Collection
from functools import cache

from roslab.decide.system.names import Target
from roslab.knowledge.carried import base_holds
from roslab.knowledge.distros import distro, distros
from roslab.knowledge.frameworks import imports
from roslab.knowledge.libraries import Library, library
from roslab.knowledge.released import ever_released, released, rosdep_keys
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern

_OF_PYTHON = pattern(r"python3?-([\w.-]+)")
"""How rosdep's keys of Python are called: https://github.com/ros/rosdistro/blob/master/CONTRIBUTING.md, 2026-11-27"""
_OF_APT = pattern(r"^ros-[a-z]+-")
BUILD_TYPES = frozenset({"ament_python"})
"""Build types that no package stands for: https://www.ros.org/reps/rep-0149.html#build-type, 2026-11-26"""


def of_pip(name: str) -> str:
    """Return the apt package of what a key names as pip does, ``""`` where it is another thing or apt has none."""
    if name in rosdep_keys() or ever_released(name):
        return ""
    by_module, by_pip = _numbered()
    found = (by_module.get(name), by_pip.get(canonicalize_name(name)))
    return min(filter(None, found), default=(0, ""))[1]


@cache
def _numbered() -> tuple[dict[str, tuple[int, str]], dict[str, tuple[int, str]]]:
    """Return the apt packages with their rows, by modules and by the names of pip in their plain spelling."""
    by_module: dict[str, tuple[int, str]] = {}
    by_pip: dict[str, tuple[int, str]] = {}
    for number, (module, (pip, apt)) in enumerate(imports().items()):
        if apt:
            by_module.setdefault(module, (number, apt))
            by_pip.setdefault(canonicalize_name(pip or ""), (number, apt))
    return by_module, by_pip


def library_called(name: str, ubuntu: str | None) -> Library | None:
    """Return where the library comes from that a key names: as CMake does, else as pkg-config or the linker does.

    Of the linker's names only those with ``lib`` before them, for the others are plain words.
    """
    found = library("cmake", name, ubuntu) or library("pkg-config", name, ubuntu)
    return found or (library("link", name[3:], ubuntu) if name.startswith("lib") else None)


def of_installed(name: str, installed: Collection[str]) -> str:
    """Return what pip installs that a key is called like, or a module of which is, ``""`` where it is none of it.

    Also behind ``python3-``, as rosdep's keys of Python are called, where pip's own name may begin with ``python-``:
    ``python3-multipart`` is python-multipart. ``installed``: names in pip's plain spelling.
    """
    of_python = _OF_PYTHON.fullmatch(name)
    called = of_python[1] if of_python else name
    brings = imports().get(called, (None, None))[0]
    names = (called, brings or called, *((f"python-{called}",) if of_python else ()))
    return next((key for key in map(canonicalize_name, names) if key in installed), "")


def packaged(name: str, target: Target) -> tuple[str, ...]:
    """Return what is installed for such a key: nothing where the Python of ROS is 2, whose packages are named else."""
    release = distro(target.ros_distro)
    apt = of_pip(name)
    return (apt,) if apt and release is not None and release.python.startswith("3") else ()


def of_python_3(name: str, target: Target) -> str:
    """Return the package of Python 3 for a key of Python 2's on an Ubuntu without Python 2, ``""`` for another key."""
    new = name.replace("python-", "python3-", 1) if name.startswith("python-") else ""
    release = distro(target.ros_distro)
    there = new in rosdep_keys() and name not in rosdep_keys()
    return new if there and release is not None and release.python.startswith("3") else ""


def as_apt_writes(name: str, target: Target) -> str:
    """Return the package of ROS that a key names as apt does (``cv-bridge``, ``ros-humble-cv-bridge``), else ``""``."""
    spelled = _OF_APT.sub("", name).replace("-", "_")
    return spelled if "-" in name and target.knows(spelled) else ""


def left_over(name: str, ros_distro: str | None) -> bool:
    """Tell whether a key for ROS 2 names a part of ROS 1 itself, which no ROS 2 has and nobody publishes for it."""
    here = distro(ros_distro)
    if here is None or here.ros != 2 or name in released(here.name):
        return False
    core = name == "catkin" or (name.startswith(("ros", "message_")) and name in base_holds(1))
    return core and not elsewhere(name, ros_distro)


def elsewhere(name: str, ros_distro: str | None) -> str:
    """Return the newest other distribution of the same ROS that released a package, ``""`` where none did."""
    here = distro(ros_distro)
    same = [each for each in distros().values() if here and each.ros == here.ros and each.name != here.name]
    return next((each.name for each in reversed(same) if name in released(each.name)), "")
