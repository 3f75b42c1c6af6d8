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


def test_the_newest_branch_is_taken_as_of_the_last_commit(tmp_path: Path, tree: Tree) -> None:
    files = {"package.xml": PACKAGE, "CMakeLists.txt": MADE, "a.repos": LIST, "README.md": "ROS Melodic\n"}
    assert [(source.ref, source.before) for source in tree(files).source] == [("master", "")]
    commit(tmp_path, "2020-06-24")
    assert [(source.ref, source.before) for source in tree(files).source] == [("master", "2020-06-24")]
    branch = files | {"a.repos": LIST.replace("master", "noetic-devel")}
    assert [(source.ref, source.before) for source in tree(branch).source] == [("noetic-devel", "2020-06-24")]
    tag = files | {"a.repos": LIST.replace("master", "v1.2")}
    assert [(source.ref, source.before) for source in tree(tag).source] == [("v1.2", "")]


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
