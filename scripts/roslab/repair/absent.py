"""Packages that a failed build has left out itself: to ask for them again repairs nothing."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

from roslab.repair.change import Repair
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_UNKNOWN = pattern(
    r"\bE: (?:Unable to locate package|Package) '?([^ '\n]{1,100})'?(?: has no installation candidate)?[ \t\r]*$",
    re.MULTILINE,
)
"""What apt says of a package that it does not have."""
_OF_ROS = pattern(r"ros-[a-z]+-(.+)")


def without_absent(found: Repair, left_out: Collection[str]) -> Repair:
    """Return a repair without the packages of apt among what the build has left out."""
    left = {*left_out}
    absent = [change for change in found.changes if change.key == "apt" and left.intersection(_names(change.value))]
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
