"""Distributions that stand only in the address of a page."""

from __future__ import annotations

import re

from roslab.knowledge.distros import distros
from roslab.values.pattern import pattern

_READ_THERE = pattern(r"https?://[^\s<>()\[\]\"']*/(?:blob|tree|raw|api)/[^\s<>()\[\]\"']*", re.IGNORECASE)
"""The address of a page that is read: a file or folder of a branch, the documentation of a message."""
_DOCUMENTATION = pattern(r"https?://docs\.ros\.org/[^\s<>()\[\]\"']*", re.IGNORECASE)


def only_read(sentence: str, name: str) -> bool:
    """Tell whether a sentence names a distribution only in the address of a file, or of a message's page."""
    return name in sentence.lower() and name not in _READ_THERE.sub("", sentence).lower()


def only_general(sentence: str, name: str) -> bool:
    """Tell whether it names rolling only in the address of ROS's documentation: pages about no release lie below it."""
    found = distros().get(name)
    return bool(found and found.never_ends and name not in _DOCUMENTATION.sub("", sentence).lower())
