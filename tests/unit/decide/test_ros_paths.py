"""A path of one distribution in a CMakeLists.txt or a launch file tells it, unless a page names another."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
AMENT = "<package><name>a</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
CMAKE = "project(a)\nfind_package(ament_cmake REQUIRED)\n"
INCLUDE = "include_directories(/opt/ros/jazzy/include)\n"
OLD_PAGE = "It needs Ubuntu 20.04 and ROS Noetic.\n"


@pytest.mark.parametrize(
    ("files", "distro"),
    [
        ({"CMakeLists.txt": CMAKE + INCLUDE, "README.md": OLD_PAGE}, "jazzy"),
        ({"launch/a.launch.py": "BAGS = '/opt/ros/jazzy/share'\n", "README.md": OLD_PAGE}, "jazzy"),
        ({"CMakeLists.txt": CMAKE + "# " + INCLUDE, "README.md": OLD_PAGE}, "foxy"),
        ({"CMakeLists.txt": CMAKE + INCLUDE, "README.md": "Tested on ROS 2 Humble.\n"}, "humble"),
        ({"third_party/b/CMakeLists.txt": CMAKE + INCLUDE, "README.md": OLD_PAGE}, "foxy"),
    ],
)
def test_a_path_of_a_distribution(tree: Tree, files: dict[str, str], distro: str) -> None:
    assert tree({"package.xml": AMENT, "CMakeLists.txt": CMAKE, **files}).ros_distro == distro
