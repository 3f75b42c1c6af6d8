"""Headers of other packages that the workspace always includes: of messages, services and actions, or files."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.ros.included import generated_headers
from roslab.decide.ros.workspace import Packages
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.evidence.native.generated import package_of
from roslab.knowledge.libraries import header
from roslab.knowledge.released import released, rosdep_keys

_MOST = 60


def included_interfaces(evidence: Evidence, packages: Packages, ros_distro: str | None) -> tuple[str, ...]:
    """Return them as ``acme_msgs/Grip`` and ``acme/grip.hpp``.

    Not those of the tree, nor of what the distribution released. A clone that is called like such a package may be of
    another branch than the one that the code was written for.
    """
    there = released(ros_distro or "")
    found: set[str] = set()
    for name, each in generated_headers(evidence, packages):
        if name not in there:
            file = each.name.rpartition("/")[2].rpartition(".")[0]
            found.add(f"{name}/{file.partition('__')[0]}")  # grip__struct.hpp of ROS 2 up to Eloquent
    files = {each for each in _files(evidence, packages) if each.partition("/")[0] not in there}
    return (*sorted(found), *sorted(files))[:_MOST]


def _files(evidence: Evidence, packages: Packages) -> Iterator[str]:
    """Yield the other headers of packages that those of the workspace ask for; what a table knows is of a library."""
    asked = {d.name for m in packages.built for d in m.dependencies if d.namespace in {"rosdep", "ros"}}
    asked -= packages.names | rosdep_keys()
    folders = tuple(manifest.file.rpartition("/")[0] for manifest in packages.built)
    for each in evidence.code:
        name, slash, _ = each.name.partition("/")
        sure = each.namespace == "include" and each.strength == "used" and slash and not places.aside(each.file)
        if not sure or name not in asked or package_of(each.name) or header(each.name, None):
            continue
        if any(not folder or each.file.startswith(f"{folder}/") for folder in folders):
            yield f"{name}/{each.name.rpartition('/')[2]}"
