"""The ROS distributions and the Ubuntu releases under them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Literal

from roslab.knowledge.table import rows


@dataclass(frozen=True, kw_only=True, slots=True)
class Distro:
    """A ROS distribution; dates are ``YYYY-MM-DD``."""

    name: str
    ros: Literal[1, 2]
    ubuntu: str
    """Codename of the Ubuntu that its official image has."""
    python: str
    released: str
    eol: str | None
    """``None`` for the one that never ends."""
    rosdistro_tag: str | None
    """Tag of ros/rosdistro to resolve keys with, where the newest tables no longer know its Ubuntu."""
    arm64: bool
    preference: int
    """Of several distributions that a repository names alike, the one with the highest number: long support with all
    packages before the newest, whose packages still come in."""


@cache
def distros() -> dict[str, Distro]:
    """Return every distribution that an image exists for by its name, the oldest first, ROS 1 before ROS 2."""
    return {
        row["name"]: Distro(
            name=row["name"],
            ros=1 if row["ros"] == "1" else 2,
            ubuntu=row["ubuntu"],
            python=row["python"],
            released=row["released"],
            eol=row["eol"] or None,
            rosdistro_tag=row["rosdistro_tag"] or None,
            arm64=row["arm64"] == "yes",
            preference=int(row["preference"]),
        )
        for row in rows("distros")
        if row["image"] == "yes"
    }


@cache
def releases_of() -> dict[str, tuple[str, ...]]:
    """Return the Ubuntu codenames that each distribution has packages for; none is named that has them for no Ubuntu.

    Those without an image are among them: roslab.yaml may say them, and so do pages.
    """
    return {row["name"]: tuple(row["releases"].split()) for row in rows("distros") if row["releases"]}


@cache
def english_words() -> frozenset[str]:
    """Return the distributions whose names are words of other things too."""
    return frozenset(row["name"] for row in rows("distros") if row["word"] == "yes")


@cache
def ever() -> frozenset[str]:
    """Return the names of all distributions that ever were: they stand in names of apt packages."""
    return frozenset(row["name"] for row in rows("distros"))


@cache
def ubuntus() -> dict[str, str]:
    """Return ``{version: codename}`` of the Ubuntu releases with long support: ``{"20.04": "focal"}``."""
    return {row["version"]: row["codename"] for row in rows("ubuntu")}


@cache
def cmake_of_ubuntu() -> dict[str, str]:
    """Return ``{codename: version}`` of the CMake that each Ubuntu release has."""
    return {row["codename"]: row["cmake"] for row in rows("ubuntu")}


@cache
def python_of_ubuntu() -> dict[str, str]:
    """Return ``{codename: version}`` of ``python3`` in each Ubuntu release."""
    return {row["codename"]: row["python"] for row in rows("ubuntu")}


def distro(name: str | None) -> Distro | None:
    """Return a distribution by its name."""
    return distros().get(name or "")


def rosdistro_tag(name: str | None) -> str | None:
    """Return the tag of ros/rosdistro that still answers for a distribution, ``None`` where the newest tables do."""
    found = distro(name)
    return found.rosdistro_tag if found else None


def distros_of(ubuntu: str | None, ros: Literal[1, 2]) -> tuple[str, ...]:
    """Return the distributions of ROS 1 or 2 on an Ubuntu, the preferred one first."""
    found = [d for d in distros().values() if d.ubuntu == ubuntu and d.ros == ros and d.name != "rolling"]
    return tuple(d.name for d in sorted(found, key=lambda d: d.preference, reverse=True))
