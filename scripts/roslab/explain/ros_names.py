"""Finds the package of ROS for a name in a log: what a distribution has released."""

from __future__ import annotations

from collections.abc import Mapping

from roslab.knowledge import libraries
from roslab.knowledge.code_limits import OF_ROS2, limits
from roslab.knowledge.distros import distro, distros
from roslab.knowledge.frameworks import imports
from roslab.knowledge.gazebo_plugins import gazebo_plugins
from roslab.knowledge.released import released


def package(names: Mapping[str, str], ros: str | None, ubuntu: str | None) -> dict[str, str]:
    """Name the apt package of a ROS package that is released; return nothing for a name that is a CMake library's.

    ``released`` holds those that this distribution, or any where it is not known, has released, as the images of ROS
    name them: they set ``ROS_DISTRO``.
    """
    wanted = [name for name in names.get("name", "").split(", ") if name]
    if not wanted or libraries.library("cmake", wanted[0], ubuntu) is not None:
        return {}
    there = [name.replace("_", "-") for name in wanted if _is_released(name, ros)]
    own = f"ros-{ros}-{wanted[0].replace('_', '-')}" if ros and _is_released(wanted[0], ros) else ""
    return {"package": own, "released": " ".join(f"ros-$ROS_DISTRO-{name}" for name in there)}


def known(names: Mapping[str, str], ros: str | None) -> dict[str, str]:
    """Name the package of a program or a library that has its name, or of a plugin of Gazebo; nothing if unknown."""
    said = names.get("name", "")
    name = gazebo_plugins().get(f"lib{said}.so", said)
    if not name or not _is_released(name, ros):
        return {}
    dashed = name.replace("_", "-")
    return {"name": name, "package": f"ros-{ros}-{dashed}" if ros else "", "released": f"ros-$ROS_DISTRO-{dashed}"}


def header(names: Mapping[str, str], ros: str | None, ubuntu: str | None) -> dict[str, str]:
    """Name the package that has a header, by a table or by its folder; none for one of the package itself.

    Where the log shows no ROS, a folder that is a plain word (``filters/``) is anybody's, and apt comes first.
    """
    said = names.get("header", "")
    folder = said.partition("/")[0]
    found = libraries.library("include", said, ubuntu)
    if ros is None and (found.apt if found else "_" not in folder):
        return {}
    name = found.ros if found else folder
    own = f"/{name}/" in f"/{names.get('file', '')}"
    return {} if own or not name else known({"name": name}, ros)


def module(names: Mapping[str, str], ros: str | None) -> dict[str, str]:
    """Name the package that has the name of a Python module; nothing for a module that pip has."""
    said = names.get("name", "")
    return {} if said in imports() else known(names, ros)


def elsewhere(names: Mapping[str, str], ros: str | None) -> dict[str, str]:
    """Name the distributions of the same generation that have a package which this one has not."""
    said, this = names.get("name", ""), distro(ros)
    if this is None or ros is None or said in imports() or said in released(ros):
        return {}
    others = [each.name for each in distros().values() if each.ros == this.ros and said in released(each.name)]
    return {"ros": ros, "releases": ", ".join(others)} if others else {}


def dropped(names: Mapping[str, str], ros: str | None) -> dict[str, str]:
    """Name the newest ROS 2 that has a command of CMake, or a header of ROS, which this one has dropped."""
    this = distro(ros)
    said = {"cmake": names.get("command", ""), "include": names.get("header", "")}
    for row in limits() if this is not None else ():
        without = distro(row.below or "") if row.library.startswith(OF_ROS2) and said.get(row.where) else None
        if this is None or without is None or not row.pattern.search(said[row.where]):
            continue
        before = [each for each in distros().values() if each.ros == without.ros and not each.never_ends]
        before = [each for each in before if each.released < without.released]
        if before and (this.never_ends or this.released >= without.released):
            return {"ros": this.name, "name": said[row.where], "last": before[-1].name}
    return {}


def _is_released(name: str, ros: str | None) -> bool:
    return any(name in released(each) for each in ([ros] if ros else distros()))
