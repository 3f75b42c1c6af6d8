"""Code of ROS without a package.xml: nothing builds it, and it runs on a machine with ROS alone."""

from __future__ import annotations

from roslab.decide.cuda.signs import sign_of_cuda
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import imports

CLIENTS = {"rospy": "ros1", "rclpy": "ros2"}
"""ROS's own libraries, which pip's index has not, and the kind of what needs each."""


def client_of(evidence: Evidence) -> Dependency | None:
    """Return the import of ROS's library by the module that is the program; ``None`` where it is a part among others.

    That is the module that imports, at its top, most of what the code takes from pip. What computes on CUDA is none:
    the image of a framework matters more to it.
    """
    used = [d for d in evidence.code if d.namespace == "import" and d.strength == "used" and not places.aside(d.file)]
    clients = [each for each in used if each.name in CLIENTS]
    if not clients or sign_of_cuda(evidence):
        return None
    of_pip = [each.file for each in used if each.name in imports()]
    return next((each for each in clients if 2 * of_pip.count(each.file) >= len(of_pip)), None)
