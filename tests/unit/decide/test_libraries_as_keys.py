"""A library that a package.xml names is compiled before the workspace, and is no package of ROS to clone there."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend><depend>{0}</depend></package>"
CMAKE = "project(demo)\nfind_package(catkin REQUIRED)\nfind_package({0} REQUIRED)\n"
BLOCK = (
    "git clone https://github.com/{0}.git && \\\n"
    "cd {1} && git checkout tags/{2} && mkdir build && cd build && \\\n"
    "cmake .. && make && make install"
)


def _files(name: str, page: str) -> dict[str, str]:
    page = f"ROS Noetic\n```\n{page}\n```\n"
    return {"package.xml": PACKAGE.format(name), "CMakeLists.txt": CMAKE.format(name), "README.md": page}


@pytest.mark.parametrize(
    ("name", "page", "ref"),
    [
        ("glog", BLOCK.format("google/glog", "glog", "v0.6.0"), "v0.6.0"),
        ("springs", BLOCK.format("lab/springs", "springs", "v0.6.0"), "v0.6.0"),
    ],
)
def test_what_a_page_compiles_is_a_library(tree: Tree, name: str, page: str, ref: str) -> None:
    decision = tree(_files(name, page))
    assert [(each.name, each.ref, each.build) for each in decision.source if each.build == "cmake"] == [
        (name, ref, "cmake")
    ]
    assert all(each.build == "cmake" for each in decision.source)
    assert name in decision.skip_keys


def test_a_link_to_what_a_recipe_compiles_is_none(tree: Tree) -> None:
    decision = tree(
        _files("glog", "") | {"README.md": "ROS Noetic\n\nWe use [glog](https://github.com/google/glog).\n"}
    )
    assert [(each.name, each.build) for each in decision.source if each.build == "cmake"] == [("glog", "cmake")]
    assert all(each.build == "cmake" for each in decision.source)


def test_a_link_to_a_package_is_still_cloned_and_may_be_plain_cmake(tree: Tree) -> None:
    page = "ROS Noetic\n\nWe use [springs](https://github.com/lab/springs).\n"
    decision = tree(_files("springs", "") | {"README.md": page})
    assert [(each.name, each.unread) for each in decision.source] == [("springs", True)]


def test_the_package_of_a_library_that_a_key_names_stops_no_other(tree: Tree) -> None:
    files = {"package.xml": PACKAGE.format("glfw3"), "README.md": "ROS Noetic\n"}
    decision = tree(files | {"CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n"})
    assert "glfw3" in decision.skip_keys
    assert "libglfw3-dev" in decision.apt_guessed
    assert "libglfw3-dev" not in decision.apt


def test_the_package_of_an_old_ubuntu_is_that_which_it_has(tree: Tree) -> None:
    decision = tree(_files("pcl", "") | {"README.md": "ROS Indigo\n"})
    assert "libpcl-1.7-all-dev" in decision.apt
    assert "libpcl-dev" not in {*decision.apt, *decision.apt_guessed}
