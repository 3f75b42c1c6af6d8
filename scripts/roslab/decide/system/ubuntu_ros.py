"""What Ubuntu itself has of ROS 1 for Python: a program that reads bags needs no more than that."""

from __future__ import annotations

from functools import cache

from roslab.decide.python.image_python import Python
from roslab.decide.ros.without_manifest import CLIENTS
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import ubuntus_with_python2
from roslab.knowledge.table import rows


@cache
def _packages() -> dict[str, str]:
    return {row["module"]: row["apt"] for row in rows("ubuntu_ros")}


@cache
def _alone() -> frozenset[str]:
    return frozenset(row["module"] for row in rows("ubuntu_ros") if row["alone"])


def of_ros1_alone(evidence: Evidence) -> Dependency | None:
    """Return the first import of what ROS 1 alone has, beside its client library: ``rosbag``; ``None`` for none.

    Not beside ROS 2's own library, whose messages have the same names.
    """
    used = _used(evidence)
    if any(CLIENTS.get(each.name) == "ros2" for each in used):
        return None
    return next((each for each in used if each.name in _alone()), None)


def ubuntu_brings(python: Python, ubuntu: str | None) -> bool:
    """Tell whether the image's Python sees what apt installs, of an Ubuntu that has ROS for Python 3."""
    return python.manager == "venv" and ubuntu is not None and ubuntu not in ubuntus_with_python2()


def ros_of_ubuntu(evidence: Evidence, python: Python, ubuntu: str | None) -> tuple[tuple[str, Dependency], ...]:
    """Return Ubuntu's packages of ROS 1 that the code imports, each with the import; none where nothing needs ROS 1."""
    if not ubuntu_brings(python, ubuntu) or not of_ros1_alone(evidence):
        return ()
    return tuple((_packages()[each.name], each) for each in _used(evidence) if each.name in _packages())


def _used(evidence: Evidence) -> list[Dependency]:
    used = (each for each in evidence.code if each.namespace == "import" and each.strength == "used")
    return [each for each in used if not places.aside(each.file)]
