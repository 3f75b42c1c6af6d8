"""The messages, services and actions of other packages whose headers the code of the workspace always includes."""

from __future__ import annotations

from roslab.decide.ros.workspace import Packages
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.evidence.native.generated import package_of
from roslab.knowledge.libraries import header
from roslab.knowledge.released import released

MOST = 60


def included_interfaces(evidence: Evidence, packages: Packages, ros_distro: str | None) -> tuple[str, ...]:
    """Return them as ``acme_msgs/Grip``, without those of the tree and of what the distribution released.

    A clone that is called like such a package may be of another branch than the one that the code was written for.
    """
    folders = tuple(manifest.file.rpartition("/")[0] for manifest in packages.built)
    there = packages.names | released(ros_distro or "")
    found: dict[str, None] = {}
    for each in evidence.code:
        name = package_of(each.name) if each.namespace == "include" and each.strength != "optional" else ""
        if not name or name in there or places.aside(each.file) or header(each.name, None):
            continue
        if any(not folder or each.file.startswith(f"{folder}/") for folder in folders):
            file = each.name.rpartition("/")[2].rpartition(".")[0]
            found.setdefault(f"{name}/{file.partition('__')[0]}")  # grip__struct.hpp of ROS 2 up to Eloquent
    return tuple(sorted(found))[:MOST]
