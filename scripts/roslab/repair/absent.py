"""Packages that a failed build has left out itself: to ask for them again repairs nothing."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.repair.change import Repair
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_LEFT_OUT = pattern(r"roslab: left out: (?:apt|rosdep) (\S{1,100})[ \t\r]*$", re.MULTILINE)
"""What the image's scripts say of a package that apt does not have, or of a key that rosdep or apt does not know."""
_UNKNOWN = pattern(
    r"\bE: (?:Unable to locate package|Package) '?([^ '\n]{1,100})'?(?: has no installation candidate)?[ \t\r]*$",
    re.MULTILINE,
)
"""What apt says of a package that it does not have."""
_OF_ROS = pattern(r"ros-[a-z]+-(.+)")


def without_absent(found: Repair, log: str) -> Repair:
    """Return a repair without the packages of apt that the log says were left out; ``log``: of the whole build."""
    asked = [change for change in found.changes if change.key == "apt"]
    left = {match[1] for match in _LEFT_OUT.finditer(log)} if asked and "roslab: left out: " in log else set()
    absent = [change for change in asked if left.intersection(_names(change.value))]
    if not absent:
        return found
    refused = tuple((each.failure, f"{each.asked} is missing, and apt has no {each.value} here") for each in absent)
    return replace(
        found,
        changes=tuple(change for change in found.changes if change not in absent),
        refused=(*found.refused, *refused),
    )


def unknown_to_apt(log: str) -> set[str]:
    """Return the packages of which apt says in a log that it does not have them."""
    return {match[1] for match in _UNKNOWN.finditer(log)} if "E: " in log else set()


def _names(package: str) -> Iterator[str]:
    """Yield a package's name, and what rosdep calls one of ROS."""
    yield package
    if of_ros := _OF_ROS.fullmatch(package):
        yield of_ros[1].replace("-", "_")
        yield of_ros[1]
