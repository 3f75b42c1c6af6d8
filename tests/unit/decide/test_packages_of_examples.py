"""A package in a folder of examples is built with the others: what its CMake requires is brought."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>"
CMAKE = "project({name})\nfind_package(catkin REQUIRED)\nfind_package(Pangolin REQUIRED)\ncatkin_package()\n"
OWN = {
    "demo/package.xml": PACKAGE.format(name="demo"),
    "demo/CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
    "README.md": "ROS Kinetic\n",
}


@pytest.mark.parametrize(
    ("folder", "package", "found"),
    [
        ("slam/Examples/ROS/slam", "slam/Examples/ROS/slam", ["pangolin"]),
        ("viewer", "viewer", ["pangolin"]),
        ("viewer/examples", "viewer", []),
        ("viewer/test", "viewer", []),
    ],
)
def test_what_a_package_of_examples_requires(tree: Tree, folder: str, package: str, found: list[str]) -> None:
    files = {
        f"{package}/package.xml": PACKAGE.format(name="viewer"),
        f"{package}/CMakeLists.txt": "project(viewer)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
        f"{folder}/CMakeLists.txt": CMAKE.format(name="viewer"),
    }
    assert [source.name for source in tree({**OWN, **files}).source] == found


@pytest.mark.parametrize(
    ("folder", "others", "kind"),
    [
        ("examples/talker", {"core/CMakeLists.txt": "project(core)\nadd_executable(core main.cpp)\n"}, "cpp"),
        ("examples/talker", {"setup.py": "from setuptools import setup\nsetup(name='core')\n"}, "python"),
        ("examples/talker", {}, "ros1"),
        ("examples/talker", {"CMakeLists.txt": "project(core)\nadd_library(core core/more.cpp)\n"}, "ros1"),
        ("talker", {"core/CMakeLists.txt": "project(core)\nadd_executable(core main.cpp)\n"}, "ros1"),
    ],
)
def test_packages_that_are_examples_of_another_program(
    tree: Tree, folder: str, others: dict[str, str], kind: str
) -> None:
    files = {
        f"{folder}/package.xml": PACKAGE.format(name="talker"),
        f"{folder}/CMakeLists.txt": "project(talker)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
        "core/main.cpp": '#include "more.hpp"\nint main() {}\n',
        "core/more.cpp": "#include <Eigen/Core>\nint more() {}\n",
    }
    assert tree({**files, **others}).kind == kind
