"""A Python library that needs ROS for a real robot alone: its image is plain Python's, with nothing for the robot."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable
from typing import Protocol, TypeVar

from roslab.config.model import Config
from roslab.decide.best_dockerfile import built_by_pages
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.without_manifest import CLIENTS
from roslab.evidence.facts import AuthorDockerfile, Evidence, Mention
from roslab.values.dataclass import replace


class _Placed(Protocol):
    @property
    def file(self) -> str: ...


_Found = TypeVar("_Found", bound=_Placed)


def called_optional(evidence: Evidence) -> Mention | None:
    """Return where the page says so, ``None`` where it does not, where a package is there, or pip installs nothing.

    ``None``, too, where every image that pages build has ROS.
    """
    if evidence.manifests or not any(each.installable and not each.folder for each in evidence.python):
        return None
    said = next((mention for mention in evidence.mentions if mention.topic == "optional_ros"), None)
    shown = _shown(evidence) if said else ()
    return None if shown and all(each.ros != "none" for each in shown) else said


def _shown(evidence: Evidence) -> tuple[AuthorDockerfile, ...]:
    """Return the Dockerfiles that pages build."""
    named = built_by_pages(evidence)
    return tuple(each for each in evidence.dockerfiles if each.file in named)


def without_optional_ros(evidence: Evidence, config: Config) -> Evidence:
    """Return the evidence without the Dockerfiles in folders that name ROS, but for those that pages build.

    What lies in such a folder goes with them where it has no other Dockerfile.

    Where the page at the root says that not everybody needs ROS, no package is for it, and pip installs the root.
    Whoever chooses ROS or a Dockerfile in roslab.yaml has all of it.
    """
    chosen = config.kind in {"ros1", "ros2"} or config.base.ros or config.base.image or config.dockerfile
    if chosen or called_optional(evidence) is None:
        return evidence
    shown = {posixpath.dirname(each.file) for each in _shown(evidence)}
    dropped = {each.file for each in evidence.dockerfiles if each.ros == "named" and "/" in each.file}
    dropped = {file for file in dropped if posixpath.dirname(file) not in shown}
    if not dropped:
        return evidence
    others = [each.file for each in evidence.dockerfiles if each.file not in dropped]
    folders = [f"{posixpath.dirname(file)}/" for file in dropped]
    alone = tuple(folder for folder in folders if not any(file.startswith(folder) for file in others))

    def kept(found: Iterable[_Found]) -> tuple[_Found, ...]:
        return tuple(each for each in found if each.file not in dropped and not each.file.startswith(alone))

    return replace(
        evidence,
        dockerfiles=kept(evidence.dockerfiles),
        prose=kept(evidence.prose),
        prose_pip=kept(evidence.prose_pip),
        sources=kept(evidence.sources),
        apt_sources=kept(evidence.apt_sources),
        mentions=kept(evidence.mentions),
    )


def told_of_optional_ros(evidence: Evidence) -> tuple[Warning_, ...]:
    """Return a warning where the code needs ROS in part, and the image has none as the page calls it optional."""
    said = called_optional(evidence)
    used = [each.name for each in evidence.code if each.namespace == "import" and each.name in CLIENTS]
    if said is None or not used:
        return ()
    message = f"{said.file} says that not everybody needs ROS: the image has none, and what imports {used[0]} stops"
    return (warn(f"{message}; `kind: {CLIENTS[used[0]]}` in roslab.yaml makes an image with it", said),)
