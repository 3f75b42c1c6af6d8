"""Packages of which the README runs programs, and that nothing is known to bring."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\nadd_executable(node a.cpp)\n",
}


@pytest.mark.parametrize(
    ("commands", "named"),
    [
        ("rosrun acme_arm node\nroslaunch acme_world a.launch\nrosrun demo node\n", "acme_arm, acme_world"),
        ("rosrun demo node\nrosrun tf2_ros static_transform_publisher\n", ""),
        ("rosrun your_package node\n", ""),
        ("git clone https://github.com/lab/acme_arm\nrosrun acme_arm node\n", ""),
        ("sudo apt install ros-noetic-acme-arm\nrosrun acme_arm node\n", ""),
    ],
)
def test_they_are_told(tree: Tree, commands: str, named: str) -> None:
    page = f"ROS Noetic\n```\ncd ~/ws/src\n{commands}```\n"
    warnings = [each.message for each in tree({**FILES, "README.md": page}).warnings]
    told = [each for each in warnings if each.startswith("the README runs programs of")]
    assert told == ([each for each in told if f" of {named}: " in each] if named else [])
    assert len(told) == bool(named)
