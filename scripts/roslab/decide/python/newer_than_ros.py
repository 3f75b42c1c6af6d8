"""Nodes whose code is of a newer Python than their ROS has: the image cannot exchange that one."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence
from roslab.evidence.places import aside
from roslab.evidence.python.limits import NODES
from roslab.knowledge.distros import python_of_ubuntu
from roslab.values.version import Version


def newer_than_ros(evidence: Evidence, ubuntu: str | None, ros_distro: str | None) -> Iterator[Warning_]:
    """Yield a warning for the sign of the newest Python in the code of nodes, if their ROS has an older one."""
    ours = python_of_ubuntu().get(ubuntu or "") if ros_distro else None
    found = [each for each in evidence.limits if each.library == NODES and each.at_least and not aside(each.file)]
    if not ours or not found:
        return
    newest = max(found, key=lambda each: Version(each.at_least or "0"))
    if Version(newest.at_least or "0") > Version(ours):
        message = f"the code of a node uses {newest.what}, which came with Python {newest.at_least}"
        yield warn(f"{message}; the Python of ROS {ros_distro} is {ours}", newest)
