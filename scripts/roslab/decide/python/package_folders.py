"""The folders of ROS packages, whose names tell nothing of what a list in them is for: ``ros_robot``, ``web_gui``."""

from __future__ import annotations

from collections.abc import Collection

from roslab.evidence.facts import Evidence


def around_packages(evidence: Evidence) -> frozenset[str]:
    """Return the folders of the packages of ROS, and those around them."""
    folders = {manifest.file.rpartition("/")[0] for manifest in evidence.manifests if not manifest.ignored}
    parts = [folder.split("/") for folder in folders if folder]
    return frozenset("/".join(each[:end]) for each in parts for end in range(1, len(each) + 1))


def below(path: str, folders: Collection[str]) -> str:
    """Return the part of a path below the last of these folders that it leads through."""
    parts = path.split("/")
    start = next((end for end in range(len(parts) - 1, 0, -1) if "/".join(parts[:end]) in folders), 0)
    return "/".join(parts[start:])
