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
