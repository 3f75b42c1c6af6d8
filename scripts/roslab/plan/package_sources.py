"""Where a base's packages come from: ROS's own source, and what is done about a base that has ended."""

from __future__ import annotations

import re
from dataclasses import dataclass

from roslab.decide.decision import Decision
from roslab.knowledge.distros import distro, has_ended
from roslab.knowledge.ros_packages import ros_packages

_OFFICIAL = re.compile(r"(?:docker\.io/(?:library/)?)?ros:")
_WITH_ROS = re.compile(r"(?:[^/]+/)*ros:")


@dataclass(frozen=True, kw_only=True, slots=True)
class RosSource:
    """A package source of ROS."""

    distro: str
    ubuntu: str
    url: str
    key: str
    """Name of the key that signs it, of ``keys.csv``."""
    in_base: bool
    """The base is an image of ROS: its own source is replaced, and none is added where it has none."""


@dataclass(frozen=True, kw_only=True, slots=True)
class PackageSources:
    """What is changed in the package sources of a base."""

    ros: RosSource | None
    """``None`` where the image needs no ROS, or the base's own source is right."""
    ended: bool
    """The base's release has ended, or its keys were replaced: each source is tried before anything is installed."""


def package_sources(decision: Decision) -> PackageSources | None:
    """Return what is changed, ``None`` for nothing: the author's own Dockerfile, or a base that is still maintained.

    The name of a base tells whether it has ROS; if another one has it too, apt finds its packages installed.
    """
    if decision.dockerfile:
        return None
    # NVIDIA replaced its key in 2022, and images of before are not told from later ones by their names
    ended = decision.base_image.startswith("nvidia/") or has_ended(decision.ubuntu)
    ros = _ros(decision)
    return PackageSources(ros=ros, ended=ended) if ros or ended else None


def _ros(decision: Decision) -> RosSource | None:
    release = distro(decision.ros_distro)
    if release is None or decision.kind not in ("ros1", "ros2"):
        return None
    in_base = bool(_WITH_ROS.match(decision.base_image))
    # Only the official images of what is maintained are built again and again
    if in_base and release.rosdistro_tag is None and _OFFICIAL.match(decision.base_image):
        return None
    source = ros_packages(release)
    return RosSource(distro=release.name, ubuntu=release.ubuntu, url=source.url, key=source.key, in_base=in_base)
