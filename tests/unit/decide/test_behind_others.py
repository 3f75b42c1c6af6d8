"""The program of the tree that a page starts behind those of others: a driver, a planner."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>{}</name><version>1.0.0</version><buildtool_depend>catkin</buildtool_depend></package>"
FILES = {
    "probing/package.xml": PACKAGE.format("probing"),
    "probing/CMakeLists.txt": "project(probing)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
    "probing/scripts/sim_test.py": "#!/usr/bin/env python3\nimport rospy\n",
    "sensor/package.xml": PACKAGE.format("sensor"),
    "sensor/CMakeLists.txt": "project(sensor)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
    "sensor/launch/hub.launch": '<launch><node pkg="rospy" type="x" name="x"/></launch>\n',
}
DRIVER = "```roslaunch ur_robot_driver ur5e_bringup.launch```\n\nThen our own client:\n\n"


@pytest.mark.parametrize(
    ("page", "command"),
    [
        (f"{DRIVER}``` rosrun probing sim_test.py ```\n", ("rosrun", "probing", "sim_test.py")),
        (f"{DRIVER}# Tests\n```\nrosrun probing sim_test.py\n```\n", ("roslaunch", "sensor", "hub.launch")),
        ("``` rosrun probing sim_test.py ```\n", ("roslaunch", "sensor", "hub.launch")),
    ],
)
def test_it_is_the_default_command_though_it_is_named_like_a_test(
    tree: Tree, page: str, command: tuple[str, ...]
) -> None:
    assert tree(FILES | {"README.md": page}).command == command
