"""One catkin_make stops where two of its packages have a CMake target of the same name."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


def package(name: str, *lines: str) -> dict[str, str]:
    xml = f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>"
    code = "\n".join((f"project({name})", "find_package(catkin REQUIRED)", *lines, ""))
    return {f"{name}/package.xml": xml, f"{name}/CMakeLists.txt": code}


STOPPER = "add_executable(stopper a.cpp)"
PAGE = {"README.md": "```\ncatkin_make\n```\n"}
BUILD = {"Dockerfile": "FROM ros:noetic\nCOPY a /ws/src/a\nRUN cd /ws && catkin_make\n"}


@pytest.mark.parametrize(
    ("files", "tool"),
    [
        (package("a", STOPPER) | package("b", STOPPER), "catkin_make_isolated"),
        (package("a", STOPPER) | package("b", STOPPER) | PAGE, "catkin_make_isolated"),
        (package("a", STOPPER) | package("b", "add_library(stopper a.cpp)"), "catkin_make_isolated"),
        (package("a", STOPPER) | package("b", STOPPER) | {"README.md": "```\ncatkin build\n```\n"}, "catkin_tools"),
        (package("a", STOPPER) | package("b", "add_executable(b_stopper a.cpp)"), "catkin_make"),
        (package("a", STOPPER) | package("b", "add_library(stopper SHARED IMPORTED)"), "catkin_make"),
        (package("a", STOPPER) | package("b", "if(WITH_STOPPER)", STOPPER, "endif()"), "catkin_make"),
        (package("a", STOPPER) | package("b", "# " + STOPPER), "catkin_make"),
        (
            package("a", STOPPER)
            | package("b", "add_executable(b_s a.cpp)", "set_target_properties(b_s PROPERTIES OUTPUT_NAME stopper)"),
            "catkin_make",
        ),
        (
            package("a", "add_executable(${PROJECT_NAME}_node a.cpp)")
            | package("b", "add_executable(${PROJECT_NAME}_node a.cpp)"),
            "catkin_make",
        ),
        (package("a", STOPPER) | package("b", STOPPER) | {"b/CATKIN_IGNORE": ""}, "catkin_make"),
        (package("a", STOPPER) | package("b") | package("b/a", STOPPER), "catkin_make"),
        (package("a", STOPPER) | package("b", "add_subdirectory(a)") | package("b/a", STOPPER), "catkin_make_isolated"),
    ],
)
def test_packages_with_equal_targets_are_built_one_by_one(tree: Tree, files: dict[str, str], tool: str) -> None:
    assert tree(files).build_tool == tool
