"""A version of a ROS package that CMake asks for rules out the distributions whose own is older."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
AMENT = "<package><name>a</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
START = "project(a)\nfind_package(ament_cmake REQUIRED)\n"
STOPS = "if(NOT controller_manager_FOUND)\n  message(FATAL_ERROR old)\nendif()\n"
CLONED = "repositories:\n  ros2_control:\n    {type: git, url: 'https://github.com/ros-controls/ros2_control'}\n"


@pytest.mark.parametrize(
    ("asked", "distro"),
    [
        ("find_package(controller_manager 4.0.0)\n" + STOPS, "jazzy"),
        ("find_package(hardware_interface 4.0 REQUIRED)\n", "jazzy"),
        ("find_package(controller_manager 2.0.0 REQUIRED)\n", "humble"),
        ("find_package(controller_manager 400 REQUIRED)\n", "humble"),
        ("if(NEW)\nfind_package(controller_manager 4.0.0 REQUIRED)\nendif()\n", "humble"),
        ("find_package(Eigen3 3.3 REQUIRED)\n", "humble"),
    ],
)
def test_a_version_that_cmake_asks_for(tree: Tree, asked: str, distro: str) -> None:
    assert tree({"package.xml": AMENT, "CMakeLists.txt": START + asked}).ros_distro == distro


def test_a_page_that_names_an_older_distribution(tree: Tree) -> None:
    asked = "find_package(controller_manager 4.0.0 REQUIRED)\n"
    page = {"README.md": "Tested on ROS 2 Humble.\n"}
    assert tree({"package.xml": AMENT, "CMakeLists.txt": START + asked, **page}).ros_distro == "jazzy"


def test_what_is_cloned_has_any_version(tree: Tree) -> None:
    asked = "find_package(controller_manager 4.0.0 REQUIRED)\n"
    tree_ = {
        "a/package.xml": AMENT,
        "a/CMakeLists.txt": START + asked,
        "a.repos": CLONED,
        "README.md": "vcs import < a.repos\n",
    }
    assert tree(tree_).ros_distro == "humble"
