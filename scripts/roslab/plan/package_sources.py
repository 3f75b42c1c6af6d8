"""Where a base's packages come from: ROS's own source, and what is done about a base that has ended, or will."""

from __future__ import annotations

from roslab.decide.decision import Decision
from roslab.knowledge.days import last_sync
from roslab.knowledge.distros import Distro, distro
from roslab.knowledge.os_releases import ends, has_ended, release_of
from roslab.knowledge.ros_packages import last_snapshot, ros_packages, snapshot
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

_OFFICIAL = pattern(r"(?:docker\.io/(?:library/)?)?ros:")
_WITH_ROS = pattern(r"(?:[^/]+/)*ros:")


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
    otherwise: str | None = None
    """Address that is taken where ``url`` does not answer, ``own`` for the base's; ``None``: ``url`` or nothing."""


@dataclass(frozen=True, kw_only=True, slots=True)
class End:
    """What is done once a base that is maintained today has ended, so that its image can be built in ten years too."""

    day: str
    """``YYYY-MM-DD``: until then nothing is done."""
    ros: RosSource | None
    """The last snapshot of a distribution of ROS; used where it answers."""


@dataclass(frozen=True, kw_only=True, slots=True)
class PackageSources:
    """What is changed in the package sources of a base."""

    ros: RosSource | None
    """``None`` where the image needs no ROS, or the base's own source is right."""
    ended: bool
    """The base's release has ended, or its keys were replaced: each source is tried before anything is installed."""
    end: End | None
    """``None`` where it has ended already, or nothing tells when it will."""


def package_sources(decision: Decision) -> PackageSources | None:
    """Return what is changed, ``None`` for nothing: the author's own Dockerfile, or a base of an unknown release."""
    if decision.dockerfile:
        return None
    release = distro(decision.ros_distro) if decision.kind in ("ros1", "ros2") else None
    return sources_of(decision.base_image, decision.ubuntu, release, decision.day)


def sources_of(image: str, ubuntu: str | None, release: Distro | None, on: str | None = None) -> PackageSources | None:
    """Return what is changed in an image's package sources; ``release`` is the ROS that must be there, ``on`` a day.

    The name of a base tells whether it has ROS; if another one has it too, apt finds its packages installed.
    """
    codename = ubuntu or release_of(image)
    # NVIDIA replaced its key in 2022, and images of before are not told from later ones by their names
    ended = image.startswith("nvidia/") or has_ended(codename)
    ros = _ros(image, release) if release else None
    if release and on and (sync := last_sync(release.name, on)) and sync.snapshot:
        source = snapshot(release, sync.day)
        in_base = bool(_WITH_ROS.match(image))
        ros = RosSource(
            distro=release.name,
            ubuntu=release.ubuntu,
            url=source.url,
            key=source.key,
            in_base=in_base,
            otherwise=ros_packages(release).url if release.rosdistro_tag else "own",
        )
    day = ends().get(codename or "", "") if not has_ended(codename) else ""
    if release and release.eol and release.rosdistro_tag is None:
        day = min(day or release.eol, release.eol)
    end = End(day=day, ros=_later(image, release) if release and not (ros and ros.otherwise) else None) if day else None
    return PackageSources(ros=ros, ended=ended, end=end) if ros or ended or end else None


def _ros(image: str, release: Distro) -> RosSource | None:
    in_base = bool(_WITH_ROS.match(image))
    # Only the official images of what is maintained are built again and again
    if in_base and release.rosdistro_tag is None and _OFFICIAL.match(image):
        return None
    source = ros_packages(release)
    return RosSource(distro=release.name, ubuntu=release.ubuntu, url=source.url, key=source.key, in_base=in_base)


def _later(image: str, release: Distro) -> RosSource | None:
    """Return the snapshot that a maintained distribution will end with; rolling has no last one."""
    if release.never_ends or release.rosdistro_tag:
        return None
    source = last_snapshot(release)
    in_base = bool(_WITH_ROS.match(image))
    return RosSource(distro=release.name, ubuntu=release.ubuntu, url=source.url, key=source.key, in_base=in_base)
