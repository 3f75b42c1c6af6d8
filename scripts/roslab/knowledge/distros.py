"""The ROS distributions and the Ubuntu releases under them."""

from __future__ import annotations

from functools import cache
from typing import Literal

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Distro:
    """A ROS distribution; dates are ``YYYY-MM-DD``."""

    name: str
    ros: Literal[1, 2]
    ubuntu: str
    """Codename of the Ubuntu under its official image."""
    python: str
    released: str
    eol: str | None
    """``None`` for rolling, which never ends."""
    rosdistro_tag: str | None
    """Tag of ros/rosdistro to resolve keys with, if the newest tables no longer have its Ubuntu."""
    arm64: bool
    preference: int
    """If several distributions have equal evidence, the highest number is taken: one with long support wins over
    a newer one, for which packages are still being released."""
    middleware: str
    """The one that its images have, of ROS 2; https://ros.org/reps/rep-2000.html calls it the default."""
    default: bool
    """It is used when nothing names one: the last of ROS 1, and the ROS 2 on which most of 120 repositories work."""

    @property
    def never_ends(self) -> bool:
        """Whether it is rolling, which is developed continuously."""
        return self.eol is None


@cache
def distros() -> dict[str, Distro]:
    """Return every distribution with an image, by name: the oldest first, ROS 1 before ROS 2."""
    return {
        row["name"]: record(
            Distro,
            row,
            ros=1 if row["ros"] == "1" else 2,
            arm64=row["arm64"] == "yes",
            preference=int(row["preference"]),
            default=row["default"] == "yes",
        )
        for row in rows("distros")
        if row["image"] == "yes"
    }


@cache
def releases_of() -> dict[str, tuple[str, ...]]:
    """Return, for each distribution with packages, the codenames of its Ubuntu releases.

    Distributions without an image are included: roslab.yaml and pages may name them.
    """
    return {row["name"]: tuple(row["releases"].split()) for row in rows("distros") if row["releases"]}


@cache
def english_words() -> frozenset[str]:
    """Return the distributions whose names are also ordinary words."""
    return frozenset(row["name"] for row in rows("distros") if row["word"] == "yes")


@cache
def ever() -> frozenset[str]:
    """Return the names of all distributions there ever were, as found in names of apt packages."""
    return frozenset(row["name"] for row in rows("distros"))


@cache
def ubuntus() -> dict[str, str]:
    """Return ``{version: codename}`` of the Ubuntu releases with long support: ``{"20.04": "focal"}``."""
    return {row["version"]: row["codename"] for row in rows("ubuntu")}


@cache
def ubuntus_with_python2() -> frozenset[str]:
    """Return the codenames of the releases where ``python``, and the Python of ROS 1, is Python 2.

    https://wiki.ubuntu.com/FocalFossa/ReleaseNotes#Python3_by_default
    """
    return frozenset(d.ubuntu for d in distros().values() if d.python.startswith("2."))


@cache
def cmake_of_ubuntu() -> dict[str, str]:
    """Return ``{codename: version}`` of the CMake that each Ubuntu release has."""
    return {row["codename"]: row["cmake"] for row in rows("ubuntu")}


@cache
def python_of_ubuntu() -> dict[str, str]:
    """Return ``{codename: version}`` of ``python3`` in each Ubuntu release."""
    return {row["codename"]: row["python"] for row in rows("ubuntu")}


@cache
def ubuntu_released() -> dict[str, str]:
    """Return ``{codename: date}`` of the release of each Ubuntu, oldest first."""
    return {row["codename"]: row["released"] for row in rows("ubuntu")}


@cache
def variants() -> dict[str, bool]:
    """Return ``{variant: whether every distribution has an official image of it}``: ``ros-base``, ``desktop``.

    Other variants have images for one platform or some distributions only: they are installed on ``ros-base``.
    """
    return {row["variant"]: row["image"] == "yes" for row in rows("ros_variants")}


def distro(name: str | None) -> Distro | None:
    """Return a distribution by its name."""
    return distros().get(name or "")


def successor(name: str) -> Distro | None:
    """Return the first distribution with an image after one that never had any, ``None`` for other names."""
    listed = rows("distros")
    lacking = next((number for number, row in enumerate(listed) if row["name"] == name and row["image"] != "yes"), None)
    if lacking is None:
        return None
    ros = listed[lacking]["ros"]
    return next((distro(row["name"]) for row in listed[lacking:] if row["image"] == "yes" and row["ros"] == ros), None)


def distros_without_image(ros: int) -> tuple[str, ...]:
    """Return the names of the distributions of a ROS version that have no image, the oldest first."""
    return tuple(row["name"] for row in rows("distros") if row["ros"] == str(ros) and row["image"] != "yes")


def default_distro(ros: Literal[1, 2]) -> Distro:
    """Return the distribution of a ROS version that is used when nothing names one."""
    return next(found for found in distros().values() if found.ros == ros and found.default)


def rosdistro_tag(name: str | None) -> str | None:
    """Return the tag of ros/rosdistro whose tables still have a distribution, ``None`` if the newest have it."""
    found = distro(name)
    return found.rosdistro_tag if found else None


def distros_of(ubuntu: str | None, ros: Literal[1, 2]) -> tuple[str, ...]:
    """Return the distributions of ROS 1 or 2 on an Ubuntu, the preferred one first."""
    found = [d for d in distros().values() if d.ubuntu == ubuntu and d.ros == ros and not d.never_ends]
    return tuple(d.name for d in sorted(found, key=lambda d: d.preference, reverse=True))


def codename_of(image: str) -> str | None:
    """Return the Ubuntu of an image's name: ``nvidia/cuda:…-ubuntu20.04``, ``ubuntu:focal``, ``ros:noetic``."""
    for version, codename in ubuntus().items():
        if codename in image or f"ubuntu{version}" in image or f"ubuntu:{version}" in image:
            return codename
    for name, found in distros().items():
        if f":{name}" in image or f"-{name}" in image:
            return found.ubuntu
    return None
