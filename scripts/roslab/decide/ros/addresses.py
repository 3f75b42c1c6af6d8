"""Distributions that stand only in the address of a page, or beside a badge of a release."""

from __future__ import annotations

import re

from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import distros
from roslab.values.pattern import pattern

_READ_THERE = pattern(r"https?://[^\s<>()\[\]\"']*/(?:blob|tree|raw|api)/[^\s<>()\[\]\"']*", re.IGNORECASE)
"""The address of a page that is read: a file or folder of a branch, the documentation of a message."""
_DOCUMENTATION = pattern(r"https?://docs\.ros\.org/[^\s<>()\[\]\"']*", re.IGNORECASE)
_BADGE = pattern(r"https?://(?:[\w-]+\.)*(?:build\.ros2?\.org|travis-ci\.(?:org|com))/", re.IGNORECASE)
"""A badge of ROS's build farm, or of a service that built the package for each distribution."""


def released_for(page: str, sentence: str) -> bool:
    """Tell whether a page below the root only has a badge of a release there: a package is released for many.

    The badges of a package that lies in a workspace tell what its authors released, not what this workspace is for.
    """
    return "/" in page and bool(_BADGE.search(sentence))


def only_read(sentence: str, name: str) -> bool:
    """Tell whether a sentence names a distribution only in the address of a file, or of a message's page."""
    return name in sentence.lower() and name not in _READ_THERE.sub("", sentence).lower()


def beside_packages(page: str, evidence: Evidence) -> bool:
    """Tell whether a page is about a folder in which no package lies, and which lies in none: it is of another time."""
    folder = page.rpartition("/")[0]
    folders = {manifest.file.rpartition("/")[0] for manifest in evidence.manifests}
    within = any(f"{each}/".startswith(f"{folder}/") or f"{folder}/".startswith(f"{each}/") for each in folders)
    return bool(folder and folders) and not (within or "" in folders or places.documentation(page))


def only_general(sentence: str, name: str) -> bool:
    """Tell whether it names rolling only in the address of ROS's documentation: pages about no release lie below it."""
    found = distros().get(name)
    return bool(found and found.never_ends and name not in _DOCUMENTATION.sub("", sentence).lower())
