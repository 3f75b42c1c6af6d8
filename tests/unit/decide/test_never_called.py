"""A package.xml that names catkin is no package of it where CMake never calls it and the page builds by CMake alone."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = "<package><name>core</name><buildtool_depend>catkin</buildtool_depend></package>"
PLAIN = "cmake_minimum_required(VERSION 3.10)\nproject(core)\nfind_package(Eigen3 REQUIRED)\nadd_library(core a.cpp)\n"
OF_CATKIN = f"{PLAIN}find_package(catkin REQUIRED)\ncatkin_package()\n"
BY_CMAKE = "```\nmkdir build && cd build\ncmake ..\nmake install\n```\n"
BY_CATKIN = "```\ncatkin build\n```\n"


@pytest.mark.parametrize(
    ("cmake", "page", "kind"),
    [
        (PLAIN, BY_CMAKE, "cpp"),
        (PLAIN, BY_CATKIN, "ros1"),
        (PLAIN, BY_CMAKE + BY_CATKIN, "ros1"),
        (PLAIN, "", "ros1"),
        (OF_CATKIN, BY_CMAKE, "ros1"),
    ],
)
def test_what_builds_a_package_whose_cmake_calls_nothing(tree: Tree, cmake: str, page: str, kind: str) -> None:
    files = {"package.xml": MANIFEST, "CMakeLists.txt": cmake, "README.md": page, "a.cpp": "#include <Eigen/Core>\n"}
    assert tree(files).kind == kind
