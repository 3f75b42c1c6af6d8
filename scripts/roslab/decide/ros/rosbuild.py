"""What the manifests of rosbuild name and ROS no longer has: rosmake stops at such a name before it compiles."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import Packages, of_rosbuild
from roslab.evidence.dependency import Dependency
from roslab.knowledge.released import released, rosdep_keys


def ended_in(packages: Packages, ros_distro: str | None, provided: Iterable[str]) -> dict[str, Dependency]:
    """Return the packages that manifests of rosbuild name and that neither ROS nor ``provided`` has, sorted by name.

    Packages that wrapped a library ended when ROS took the library from Ubuntu: ``opencv2`` for one is none of indigo's
    (https://github.com/raulmur/ORB_SLAM/issues/37). A key of rosdep is no package, though ``provided`` names it too.
    """
    there = {plain(name) for name in (*provided, *packages.names) if name not in rosdep_keys()}
    asked = (d for manifest in packages.built if of_rosbuild(manifest) for d in manifest.dependencies)
    ended = {
        dependency.name: dependency
        for dependency in asked
        if dependency.namespace == "ros"
        and dependency.name not in released(ros_distro or "")
        and plain(dependency.name) not in there
    }
    return dict(sorted(ended.items()))
