"""A page compiles a newer release of a library than the Ubuntu has: that one is built."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
NLOPT = "https://github.com/stevengj/nlopt.git"
CERES = "https://github.com/ceres-solver/ceres-solver.git"
OPENCV = "https://github.com/opencv/opencv.git"


INSTALL = "cmake .. && make && sudo make install"
PAGE = "# Demo\n\nTested on Ubuntu 20.04.\n\n```\ngit clone {}\ncd {} && mkdir build && cd build\n{}\n```\n"


def built(tree: Tree, find: str, clone: str, after: str = INSTALL) -> dict[str, str]:
    name = clone.partition(" ")[0].rpartition("/")[2].removesuffix(".git")
    cmake = (
        f"cmake_minimum_required(VERSION 3.10)\nproject(demo)\nfind_package({find})\nadd_executable(demo main.cpp)\n"
    )
    page = PAGE.format(clone, name, after)
    found = tree({"README.md": page, "CMakeLists.txt": cmake, "main.cpp": "int main() {}\n"})
    return {each.name: each.ref or "" for each in found.source}


@pytest.mark.parametrize(
    ("find", "clone", "name", "ref"),
    [
        ("NLopt REQUIRED", f"{NLOPT} --branch v2.7.1", "nlopt", "v2.7.1"),
        ("Ceres REQUIRED", f"{CERES} -b 2.1.0", "ceres-solver", "2.1.0"),
    ],
)
def test_it_is_built(tree: Tree, find: str, clone: str, name: str, ref: str) -> None:
    assert built(tree, find, clone) == {name: ref}


@pytest.mark.parametrize(
    ("find", "clone", "after"),
    [
        # the Ubuntu's own release or an older one, no release, and one that CMake only tries
        ("NLopt REQUIRED", f"{NLOPT} --branch v2.6.1", INSTALL),
        ("Ceres REQUIRED", f"{CERES} -b 1.13.0", INSTALL),
        ("NLopt REQUIRED", NLOPT, INSTALL),
        ("NLopt REQUIRED", f"{NLOPT} --branch master", INSTALL),
        ("NLopt", f"{NLOPT} --branch v2.7.1", INSTALL),
        # it takes too long, or is not installed
        ("OpenCV REQUIRED", f"{OPENCV} --branch 4.5.5", INSTALL),
        ("NLopt REQUIRED", f"{NLOPT} --branch v2.7.1", "cmake ..\n"),
    ],
)
def test_apt_has_it(tree: Tree, find: str, clone: str, after: str) -> None:
    assert not built(tree, find, clone, after)


def test_a_release_beside_that_of_ross_packages_is_told_whatever_its_repository_is_called(tree: Tree) -> None:
    cmake = (
        "project(demo)\nfind_package(catkin REQUIRED)\nfind_package(Eigen3 REQUIRED)\nadd_executable(demo main.cpp)\n"
    )
    files = {
        "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
        "README.md": PAGE.format("https://gitlab.com/libeigen/eigen.git -b 3.4.0", "eigen", INSTALL) + "ROS Noetic\n",
    }
    found = tree({**files, "CMakeLists.txt": cmake, "main.cpp": "int main() {}\n"})
    assert [(each.name, each.ref) for each in found.source] == [("eigen", "3.4.0")]
    assert [each for each in found.warnings if each.message.startswith("eigen 3.4.0 is built beside the release")]
