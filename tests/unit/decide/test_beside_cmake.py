"""A package among the samples of a CMake project does not displace the project."""

from __future__ import annotations

from collections.abc import Callable

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>"
OF_CATKIN = "project({name})\nfind_package(catkin REQUIRED)\nfind_package(Pangolin REQUIRED)\ncatkin_package()\n"
ROOT = (
    "cmake_minimum_required(VERSION 3.30)\nproject(core CXX)\nfind_package(Eigen3 REQUIRED)\nadd_library(core a.cpp)\n"
)
NEWER = "cmake>=3.30,<4"
PAGE = "It needs Ubuntu 22.04.\n```\nmkdir build && cd build\ncmake ..\nmake\n```\n"
SAMPLE = {
    "examples/arm/package.xml": PACKAGE.format(name="arm"),
    "examples/arm/CMakeLists.txt": OF_CATKIN.format(name="arm"),
    "requirements.txt": "numpy\n",
    "plot.py": "import numpy\n",
    "a.cpp": "int one() { return 1; }\n",
    "README.md": PAGE,
}


def test_the_project_at_the_root_is_built(tree: Tree) -> None:
    decision = tree({**SAMPLE, "CMakeLists.txt": ROOT})
    assert decision.kind == "cpp"
    assert [asked.text for asked in decision.python.pip_guessed if asked.key == "cmake"] == [NEWER]
    assert "libeigen3-dev" in decision.apt
    assert not decision.source


def test_what_the_project_adds_is_a_part_of_it(tree: Tree) -> None:
    decision = tree({**SAMPLE, "CMakeLists.txt": f"{ROOT}add_subdirectory(examples/arm)\n", "README.md": PAGE})
    assert decision.kind == "cpp"
    assert [asked.text for asked in decision.python.pip_guessed if asked.key == "cmake"] == [NEWER]


def test_a_package_at_the_root_stays_a_package(tree: Tree) -> None:
    root = {"package.xml": PACKAGE.format(name="core"), "CMakeLists.txt": OF_CATKIN.format(name="core")}
    decision = tree({**SAMPLE, **root, "README.md": "ROS Noetic\n"})
    assert decision.kind == "ros1"
    assert [source.name for source in decision.source] == ["pangolin"]
