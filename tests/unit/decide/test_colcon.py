"""colcon for ROS 1, and branches that move."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from trees import commit

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
MADE = "project(demo)\nfind_package(catkin REQUIRED)\n"
LIST = "repositories:\n  acme: {type: git, url: 'https://github.com/acme/acme.git', version: master}\n"


@pytest.mark.parametrize(
    ("page", "tool"),
    [
        ("ROS Melodic\n```\ncolcon build\n```\n", "colcon"),
        ("ROS Melodic\n```\ncatkin_make\n```\n```\ncolcon build\n```\n", "catkin_make"),
        ("ROS Melodic\n```\ncatkin_make\n```\nROS 2 Foxy\n```\ncolcon build\n```\n", "catkin_make"),
        ("ROS Melodic and, on another branch, ROS Foxy\n```\ncolcon build\n```\n", "catkin_make"),
    ],
)
def test_colcon_builds_ros_1_where_nothing_is_for_ros_2(tree: Tree, page: str, tool: str) -> None:
    decision = tree({"package.xml": PACKAGE, "CMakeLists.txt": MADE, "README.md": page})
    assert (decision.kind, decision.build_tool) == ("ros1", tool)


@pytest.mark.parametrize(
    ("ref", "goes_on"),
    [
        *((name, True) for name in ("noetic-devel", "ros2", "ros-2", "ros2-dev", "ros2_devel", "feature/humble")),
        *((name, True) for name in ("dev/arms", "melodic", "jazzy-odometry", "main")),
        *((name, False) for name in ("v1.2", "1.0.0-dev", "humble-2.1", "noetic_1_0", "paper", "device", "0a1b2c3d")),
    ],
)
def test_what_goes_on_by_its_name_is_taken_as_of_the_last_commit(
    tmp_path: Path, tree: Tree, ref: str, *, goes_on: bool
) -> None:
    files = {"package.xml": PACKAGE, "CMakeLists.txt": MADE, "a.repos": LIST.replace("master", ref)}
    tree({**files, "README.md": "ROS Melodic\n"})
    commit(tmp_path, "2020-06-24")
    found = [(source.ref, source.before) for source in tree(files).source]
    assert found == [(ref, "2020-06-24" if goes_on else "")]


def test_the_newest_branch_is_taken_as_of_the_last_commit(tmp_path: Path, tree: Tree) -> None:
    files = {"package.xml": PACKAGE, "CMakeLists.txt": MADE, "a.repos": LIST, "README.md": "ROS Melodic\n"}
    assert [(source.ref, source.before) for source in tree(files).source] == [("master", "")]
    commit(tmp_path, "2020-06-24")
    assert [(source.ref, source.before) for source in tree(files).source] == [("master", "2020-06-24")]


PLAIN = "<package><name>{}</name>{}<export><build_type>cmake</build_type></export></package>"
PARTS = {
    "modules/acme_core/package.xml": PLAIN.format("acme_core", "<depend>eigen</depend>"),
    "modules/acme_core/CMakeLists.txt": "project(acme_core)\nadd_library(acme_core a.cpp)\n",
    "modules/acme_math/package.xml": PLAIN.format("acme_math", "<depend>acme_core</depend>"),
    "modules/acme_math/CMakeLists.txt": "project(acme_math)\nadd_library(acme_math a.cpp)\n",
    "doc/CMakeLists.txt": "cmake_minimum_required(VERSION 3.5)\nproject(documentation)\n",
}


@pytest.mark.parametrize(
    ("files", "page", "kind"),
    [
        ({}, "```\ncolcon build\n```\n", "ros2"),
        ({}, "```\nmkdir build\n```\n", "cpp"),
        ({"CMakeLists.txt": "project(acme)\n"}, "```\ncolcon build\n```\n", "cpp"),
    ],
)
def test_packages_of_plain_cmake_that_colcon_builds_together(
    tree: Tree, files: dict[str, str], page: str, kind: str
) -> None:
    decision = tree({**PARTS, **files, "README.md": page})
    assert decision.kind == kind
    if kind == "ros2":
        assert (decision.build_tool, decision.rosdep) == ("colcon", ("eigen",))
