"""A release that a page asks for as the least is built where it is headers alone, and told of otherwise."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
PAGE = "# Demo\n\n## Installation\n\n**Prerequisite:**\n* ROS {} \n* {}\n"


def _decide(tree: Tree, item: str, *, find: str = "Eigen3", ros: str = "Noetic") -> Decision:
    cmake = f"project(demo)\nfind_package(catkin REQUIRED)\nfind_package({find} REQUIRED)\nadd_executable(demo a.cpp)\n"
    files = {"package.xml": PACKAGE, "CMakeLists.txt": cmake, "a.cpp": "int main() {}\n"}
    return tree(files | {"README.md": PAGE.format(ros, item)})


def _built(decision: Decision) -> list[tuple[str, str | None]]:
    return [(each.name, each.ref) for each in decision.source if each.build == "cmake"]


def _told(decision: Decision) -> list[str]:
    return [each.message for each in decision.warnings if each.message.startswith("the README asks for")]


@pytest.mark.parametrize(
    "item",
    ["Eigen 3.4+", "Eigen >= 3.4", "Eigen 3.4 or newer", "Eigen 3.4+ ([3.4.1](https://a.org/e.zip) Recommended)"],
)
def test_headers_alone_are_built_in_the_release(tree: Tree, item: str) -> None:
    decision = _decide(tree, item)
    assert _built(decision) == [("eigen3", "3.4.0")]
    assert "libeigen3-dev" not in {*decision.apt, *decision.apt_guessed}
    assert not _told(decision)


@pytest.mark.parametrize("item", ["Eigen 3.3+", "Eigen 3.4", "Eigen"])
def test_what_the_ubuntu_has_or_no_least_is_left_alone(tree: Tree, item: str) -> None:
    decision = _decide(tree, item)
    assert _built(decision) == []
    assert "libeigen3-dev" in decision.apt
    assert not _told(decision)


def test_a_release_that_no_table_has_is_told(tree: Tree) -> None:
    decision = _decide(tree, "Eigen 3.9+")
    assert _built(decision) == []
    assert _told(decision)[0].startswith("the README asks for Eigen 3.9+, and this Ubuntu (focal) has 3.3.7: ")


def test_what_is_linked_is_told(tree: Tree) -> None:
    assert _told(_decide(tree, "PCL 1.12+", find="PCL"))[0].startswith("the README asks for PCL 1.12+, and this Ubuntu")
    assert not _told(_decide(tree, "PCL 1.7+ (1.10.0 Recommended)", find="PCL"))


def test_what_cmake_does_not_look_for_is_not_told(tree: Tree) -> None:
    assert not _told(_decide(tree, "PCL 1.12+"))


def test_a_variable_that_nothing_sets_has_the_folder_of_what_is_built(tmp_path: Path) -> None:
    cmake = "project(demo)\nfind_package(catkin REQUIRED)\nfind_package(Eigen3 REQUIRED)\nadd_executable(demo a.cpp)\n"
    files = {"package.xml": PACKAGE, "CMakeLists.txt": f"{cmake}include_directories(${{Eigen3_INCLUDE_DIRS}})\n"}
    files |= {"a.cpp": "int main() {}\n", "README.md": PAGE.format("Noetic", "Eigen 3.4+")}
    tree_of(tmp_path, files)
    text = dockerfile(plan_repository(tmp_path).plan)
    assert " -DEigen3_INCLUDE_DIRS=/usr/local/include/eigen3" in text
