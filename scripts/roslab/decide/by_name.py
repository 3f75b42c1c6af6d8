"""Programs of packages that ``rosrun`` and ``ros2 run`` do not find, and that are on the PATH of a sourced workspace.

Both look in ``lib/PACKAGE``; what a package of plain CMake, or one of ROS 2, installs into ``bin`` starts by its name.
ros/ros (tools/rosbash/scripts/rosrun), catkin/catkin_tools (catkin_tools/jobs/cmake.py), ros/catkin
(python/catkin/builder.py), ros2/ros2cli (ros2pkg/ros2pkg/api/__init__.py), ament/ament_package
(environment_hook/path.sh.in), colcon/colcon-core (colcon_core/environment/path.py); all read 2026-11-28.
"""

from __future__ import annotations

import shlex
from collections.abc import Mapping

from roslab.config.model import Kind
from roslab.decide.decision import Reason
from roslab.decide.programs import configured_by
from roslab.decide.ros.workspace import packages_of, types
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace

_RUN = {"ros1": ("rosrun",), "ros2": ("ros2", "run")}


def in_bin(evidence: Evidence, kind: Kind) -> Mapping[str, str]:
    """Return these programs, each with its package; of ROS 1 those of plain CMake alone, for catkin places its own."""
    making = [project for project in evidence.cmake if project.in_bin] if kind in _RUN else []
    folders = {m.file.rpartition("/")[0]: m for m in packages_of(evidence).built} if making else {}
    found: dict[str, str] = {}
    for project in making:
        package = configured_by(project, folders)
        if package and package.name and (kind == "ros2" or types(package, 1) == {"cmake"}):
            found |= dict.fromkeys(project.in_bin, package.name)
    return found


def by_name(argv: tuple[str, ...], programs: Mapping[str, str], kind: Kind) -> tuple[str, ...]:
    """Return the call of such a program by its name alone; any other command as it is."""
    start = _RUN.get(kind, ())
    package, program = (*argv[len(start) : len(start) + 2], "", "")[:2]
    if not start or argv[: len(start)] != start or programs.get(program) != package:
        return argv
    return argv[len(start) + 1 :]


def told(why: Reason, command: tuple[str, ...], called: tuple[str, ...]) -> Reason:
    """Return the reason of a command, with why it is called by its name."""
    if called == command:
        return why
    text = f"{why.reason}; its package installs it into bin, where {command[0]} does not look"
    return replace(why, answer=shlex.join(called), reason=text)
