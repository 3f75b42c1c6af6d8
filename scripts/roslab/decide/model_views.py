"""Launch files that show the model of a robot and start nothing that moves it: ``view_robot.launch``.

They open RViz beside what publishes the robot's state, as http://wiki.ros.org/urdf/Tutorials has it, and packages of
descriptions have one each.
"""

from __future__ import annotations

from collections.abc import Collection

from roslab.decide.brought_launches import with_brought
from roslab.evidence.facts import Evidence
from roslab.evidence.launch_file import LaunchFile

_WINDOWS = frozenset({"rviz", "rviz2", "joint_state_publisher", "joint_state_publisher_gui"})
_BESIDE = frozenset({"robot_state_publisher", "tf", "tf2_ros", "xacro"})
_TUTORIALS = frozenset({"urdf_tutorial", "urdf_launch"})
"""Packages of launch files that do nothing else."""
_DESCRIPTION = "_description"


def shows_model(launch: LaunchFile, evidence: Evidence) -> bool:
    """Tell whether a launch file, with those that it brings, starts nothing but what shows a robot's model.

    One in Python may name its packages in ways that are not seen: it has to be of a package called a description.
    """
    if launch.file.endswith(".py") and not (launch.package or "").endswith(_DESCRIPTION):
        return False
    if not _shows((launch,)):
        return False
    whole = with_brought(evidence, launch)
    started = {package for each in whole for package, _ in (*each.nodes, *each.includes)}
    return _shows(whole) and not started.isdisjoint(_WINDOWS | _TUTORIALS)


def _shows(whole: Collection[LaunchFile]) -> bool:
    if any(each.executes for each in whole):
        return False  # Gazebo, as often as not
    own = {each.package for each in whole}
    started = {package for each in whole for package, _ in each.nodes}
    named = {asked.name for each in whole for asked in each.dependencies if asked.namespace == "ros"}
    named |= {package for each in whole for package, _ in each.includes if package}
    beside = {name for name in named - own if not name.endswith(_DESCRIPTION)}
    return started | beside <= _WINDOWS | _BESIDE | _TUTORIALS
