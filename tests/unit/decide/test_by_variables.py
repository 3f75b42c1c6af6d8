"""A library of which ROS has a package that the code would not find, and Ubuntu one that it finds."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
FIND = "project(demo)\nfind_package(catkin REQUIRED)\nfind_package(ompl REQUIRED)\n"


@pytest.mark.parametrize(
    ("distro", "use", "apt"),
    [
        ("noetic", "target_link_libraries(demo ompl)\n", "libompl-dev"),
        ("melodic", "target_link_libraries(demo ompl)\n", "libompl-dev"),
        ("noetic", "include_directories(${OMPL_INCLUDE_DIRS})\n", "ros-noetic-ompl"),
    ],
)
def test_the_package_that_the_code_finds_is_installed(tree: Tree, distro: str, use: str, apt: str) -> None:
    files = {"package.xml": MANIFEST, "CMakeLists.txt": FIND + use, "README.md": f"ROS {distro.title()}\n"}
    found = tree(files)
    assert [name for name in (*found.apt, *found.apt_guessed) if "ompl" in name] == [apt]
