"""Folders that a tool of ROS takes for packages and cannot build are marked."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SHARE = "<package><name>{0}</name><export><build_type>{1}</build_type></export></package>"
NODE = {
    "ws/src/node/package.xml": "<package><name>node</name><depend>rclcpp</depend>"
    "<export><build_type>ament_cmake</build_type></export></package>",
    "ws/src/node/CMakeLists.txt": "project(node)\nfind_package(ament_cmake REQUIRED)\nament_package()\n",
}
CUDA = (
    "cmake_minimum_required(VERSION 3.8)\nproject(aruco)\nfind_package(CUDA REQUIRED)\nadd_library(aruco src/a.cpp)\n"
)


@pytest.mark.parametrize(
    ("files", "ignored"),
    [
        ({"msgs/std_msgs/package.xml": SHARE.format("std_msgs", "ament_cmake")}, ("msgs/std_msgs",)),
        ({"install/a/share/a/package.xml": SHARE.format("a", "ament_python")}, ("install/a/share/a",)),
        ({"docker/CMakeLists.txt": CUDA}, ("docker",)),
        ({"docker/CMakeLists.txt": CUDA, "docker/src/a.cpp": "int a;\n"}, ()),
        ({"ws/src/node/robot/package.xml": SHARE.format("robot", "ament_cmake")}, ()),
        ({"ws/src/node/docker/CMakeLists.txt": CUDA}, ()),
        ({"rusty/package.xml": SHARE.format("rusty", "ament_cargo"), "rusty/Cargo.toml": "[package]\n"}, ()),
        ({"package.xml": SHARE.format("whole", "ament_cmake")}, ()),
        ({"ws/src/node/lib/CMakeLists.txt": CUDA}, ()),
    ],
)
def test_what_nothing_builds_is_marked(tree: Tree, files: dict[str, str], ignored: tuple[str, ...]) -> None:
    assert tree(NODE | files).ignored == ignored


def test_catkin_does_not_look_at_what_has_no_manifest(tree: Tree) -> None:
    files = {
        "node/package.xml": "<package><name>node</name><buildtool_depend>catkin</buildtool_depend></package>",
        "node/CMakeLists.txt": "project(node)\nfind_package(catkin REQUIRED)\n",
        "docker/CMakeLists.txt": CUDA,
    }
    assert tree(files).ignored == ()


def test_a_project_without_its_code_needs_nothing(tree: Tree) -> None:
    decision = tree(NODE | {"docker/CMakeLists.txt": CUDA.replace("CUDA", "PCL")})
    assert not any("pcl" in name for name in (*decision.apt, *decision.apt_guessed))
    assert not any(reason.answer == "cuda" for reason in tree(NODE | {"docker/CMakeLists.txt": CUDA}).reasons)
