"""Clones that become packages of a workspace: those that a text makes in the workspace's ``src``."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_SOURCES = pattern(r"(?:^|/)[^/]*(?:ws|workspace|catkin|colcon|ros)[^/]*/src$", re.IGNORECASE)
_ASIDE = pattern(r"option|troubl|docker|hardware|simulat|advanced|develop|faq|known issue|alternativ", re.IGNORECASE)
"""Titles of sections that not everybody follows."""


def of_packages(folder: str) -> bool:
    """Tell whether ``cd`` goes into the ``src`` of a workspace; of ``cd src`` nothing else is known."""
    folder = folder.rstrip("/")
    return bool(_SOURCES.search(folder)) or folder in {"src", "./src"}


def beside(target: str, heading: str, *, inside: bool) -> bool:
    """Tell whether a clone into ``target``, ``""`` for its own name, is one of the packages.

    ``inside``: the text is in such a folder.
    """
    there = inside and not target.startswith(("/", "~", "..", "$"))
    return (there or bool(_SOURCES.search(target.rpartition("/")[0]))) and not _ASIDE.search(heading)
