"""A world of the tree that the page starts in Gazebo is the default command where the packages bring Gazebo."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = (
    '<package format="3"><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>'
    "<exec_depend>{needs}</exec_depend><export><build_type>ament_cmake</build_type></export></package>"
)
FILES = {
    "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
    "worlds/a.sdf": "<sdf/>",
    "worlds/a.world": "<sdf/>",
    "launch/a.ign": "<ignition/>",
}


@pytest.mark.parametrize(
    ("distro", "needs", "said", "command"),
    [
        ("jazzy", "ros_gz_sim", "gz sim -r worlds/a.sdf", "gz sim -r worlds/a.sdf"),
        ("jazzy", "ros_gz", "gz sim -s worlds/a.sdf", "gz sim -s worlds/a.sdf"),
        ("humble", "ros_ign_gazebo", "ign gazebo -v 4 worlds/a.sdf", "ign gazebo -v 4 worlds/a.sdf"),
        ("humble", "ros_gz_sim", "ign launch launch/a.ign", "ign launch launch/a.ign"),
        ("foxy", "gazebo_ros", "gazebo --verbose worlds/a.world", "gazebo --verbose worlds/a.world"),
        ("foxy", "gazebo_ros_pkgs", "gazebo ~/ros2_ws/worlds/b.world", "bash"),
        ("jazzy", "rclcpp", "gz sim worlds/a.sdf", "bash"),
        ("jazzy", "ros_gz_sim", "gz sim shapes.sdf", "bash"),
        ("jazzy", "ros_gz_sim", "gz topic -l worlds/a.sdf", "bash"),
    ],
)
def test_gazebo_with_a_world_of_the_tree(tree: Tree, distro: str, needs: str, said: str, command: str) -> None:
    page = f"# Demo\n\nROS 2 {distro}\n\n## Run\n\n```\n{said}\n```\n"
    found = tree({**FILES, "package.xml": PACKAGE.format(needs=needs), "README.md": page})
    assert " ".join(found.command) == command
    assert found.gui or command == "bash"


def test_a_line_outside_of_a_block(tree: Tree) -> None:
    page = "# Demo\n\nROS 2 jazzy\n\n## Run\n\ngz sim worlds/a.sdf\n\nThen run `gz topic -l`.\n"
    found = tree({**FILES, "package.xml": PACKAGE.format(needs="ros_gz_sim"), "README.md": page})
    assert found.command == ("gz", "sim", "worlds/a.sdf")
