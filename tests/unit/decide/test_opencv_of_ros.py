"""ROS kinetic has an OpenCV of its own, which cv_bridge brings: Ubuntu's older one is not put beside it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend>{}</package>"
BRIDGE = "<depend>cv_bridge</depend>"
OF_ROS, OF_UBUNTU = "ros-kinetic-opencv3", "libopencv-dev"


def _installed(tree: Tree, find: str, *, key: str = "", page: str = "ROS Kinetic on Ubuntu 16.04\n") -> set[str]:
    cmake = f"project(demo)\nfind_package(catkin REQUIRED)\nfind_package({find})\nadd_executable(demo a.cpp)\n"
    code = "#include <opencv2/core/core.hpp>\nint main() {}\n"
    files = {"package.xml": PACKAGE.format(key), "CMakeLists.txt": cmake, "a.cpp": code, "README.md": page}
    decision = tree(files)
    return {*decision.apt, *decision.apt_guessed} & {OF_ROS, OF_UBUNTU}


@pytest.mark.parametrize("find", ["OpenCV 3.0 QUIET", "OpenCV REQUIRED", "OpenCV 3 REQUIRED"])
def test_cv_bridge_brings_it(tree: Tree, find: str) -> None:
    assert _installed(tree, find, key=BRIDGE) == set()


@pytest.mark.parametrize("find", ["OpenCV REQUIRED", "OpenCV 3 REQUIRED"])
def test_it_is_installed_where_nothing_brings_it(tree: Tree, find: str) -> None:
    assert _installed(tree, find) == {OF_ROS}


def test_an_older_one_that_cmake_requires_is_ubuntus(tree: Tree) -> None:
    assert OF_UBUNTU in _installed(tree, "OpenCV 2.4 REQUIRED")


@pytest.mark.parametrize(("find", "there"), [("OpenCV 4.5 QUIET", set()), ("OpenCV 4 QUIET", {OF_UBUNTU})])
def test_a_release_that_is_only_tried_and_not_there_is_not_installed(tree: Tree, find: str, there: set[str]) -> None:
    cmake = f"project(demo)\nfind_package(catkin REQUIRED)\nfind_package({find})\nadd_executable(demo a.cpp)\n"
    files = {"package.xml": PACKAGE.format(""), "CMakeLists.txt": cmake, "a.cpp": "int main() {}\n"}
    decision = tree(files | {"README.md": "ROS Noetic\n"})
    assert {*decision.apt, *decision.apt_guessed} & {OF_UBUNTU} == there
