"""A title that names a program is no command where the block below it says how the program is started."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
BLOCK = "```\n{}\n```\n"
LAUNCHED = BLOCK.format("roslaunch slam euroc.launch")
FILES = {
    "package.xml": "<package><name>slam</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(slam)\nfind_package(catkin REQUIRED)\nadd_executable(slam_mono a.cpp)\n",
    "launch/euroc.launch": "<launch><node pkg='slam' type='slam_mono' name='a' args='config.yaml'/></launch>",
    "launch/kitti.launch": "<launch><node pkg='slam' type='slam_mono' name='a' args='kitti.yaml'/></launch>",
}


@pytest.mark.parametrize(
    ("page", "command"),
    [
        (f"## Run `slam_mono`:\n{LAUNCHED}", "roslaunch slam euroc.launch"),
        (
            f"## Run `slam_mono`\nWith data.\n\n{BLOCK.format('rosbag play a.bag')}{LAUNCHED}",
            "roslaunch slam euroc.launch",
        ),
        (f"Run `slam_mono`\n---------------\n\n{LAUNCHED}", "roslaunch slam euroc.launch"),
        (f"## Use\nRun `slam_mono`:\n\n{LAUNCHED}", "roslaunch slam euroc.launch"),
        (f"## Run `slam_mono`\nIt is fast.\n## With a file\n{LAUNCHED}", "rosrun slam slam_mono"),
        (f"## Run `slam_mono`\n{BLOCK.format('sudo apt install libeigen3-dev')}", "rosrun slam slam_mono"),
        (f"## Use\nRun `slam_mono`.\n\n{LAUNCHED}", "rosrun slam slam_mono"),
        (f"## Use\nRun `slam_mono`:\nIt is fast.\n{LAUNCHED}", "rosrun slam slam_mono"),
        ("## Use\nRun `slam_mono`:\n", "rosrun slam slam_mono"),
    ],
)
def test_a_title_above_commands(tree: Tree, page: str, command: str) -> None:
    assert " ".join(tree({**FILES, "README.md": f"# SLAM\nFor ROS Noetic.\n\n{page}"}).command) == command
