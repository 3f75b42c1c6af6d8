"""The tool that the author built a workspace with, by what it left in the tree."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = {
    "src/arm/package.xml": "<package format='2'><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>",
    "src/arm/CMakeLists.txt": "project(arm)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
}
PAGE = "# Building\n\n    catkin_make\n"
BUILT = {"build/.built_by": "catkin build", "build/CMakeCache.txt": ""}


@pytest.mark.parametrize(
    ("files", "tool"),
    [
        ({}, "catkin_make"),
        (BUILT, "catkin_tools"),
        ({"build/.built_by": "catkin_make_isolated\n"}, "catkin_make_isolated"),
        ({"build/.built_by": "colcon\n"}, "catkin_make"),
        ({".catkin_tools/CATKIN_IGNORE": ""}, "catkin_tools"),
        ({"tools/CATKIN_IGNORE": ""}, "catkin_make"),
        ({**BUILT, "src/arm/README.md": PAGE}, "catkin_tools"),  # a page of a part
        ({**BUILT, "README.md": PAGE}, "catkin_make"),
        ({"thirdparty/planner/build/.built_by": "catkin build"}, "catkin_make"),
    ],
)
def test_what_a_build_left_tells_its_tool(tree: Tree, files: dict[str, str], tool: str) -> None:
    assert tree({**PACKAGE, **files}).build_tool == tool


def test_the_reason_names_it(tree: Tree) -> None:
    said = next(reason for reason in tree({**PACKAGE, **BUILT}).reasons if reason.question == "build_tool")
    assert (said.file, said.reason) == (
        "build/.built_by",
        "build is of `catkin build`, by which the author has built it",
    )
