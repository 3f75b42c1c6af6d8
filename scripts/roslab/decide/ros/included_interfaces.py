"""The messages, services and actions of other packages whose headers the code of the workspace always includes."""

from __future__ import annotations

from roslab.decide.ros.included import generated_headers
from roslab.decide.ros.workspace import Packages
from roslab.evidence.facts import Evidence
from roslab.knowledge.released import released

_MOST = 60


def included_interfaces(evidence: Evidence, packages: Packages, ros_distro: str | None) -> tuple[str, ...]:
    """Return them as ``acme_msgs/Grip``, without those of the tree and of what the distribution released.

    A clone that is called like such a package may be of another branch than the one that the code was written for.
    """
    there = released(ros_distro or "")
    found: set[str] = set()
    for name, each in generated_headers(evidence, packages):
        if name not in there:
            file = each.name.rpartition("/")[2].rpartition(".")[0]
            found.add(f"{name}/{file.partition('__')[0]}")  # grip__struct.hpp of ROS 2 up to Eloquent
    return tuple(sorted(found))[:_MOST]
