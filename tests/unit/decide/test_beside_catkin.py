"""A package of plain CMake that needs what ROS 1 alone brings is built in a workspace of catkin."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package format='2'><name>arm</name>{}<export><build_type>cmake</build_type></export></package>"
BESIDE = "<exec_depend>catkin</exec_depend>"
FOR_ROS_1 = "<exec_depend condition='$ROS_VERSION == 1'>catkin</exec_depend>"
OLD = "<run_depend>catkin</run_depend>"
MSGS = "<depend>controller_manager_msgs</depend>"
PAGE = "# Arm\n\n## Build\n\n```\nmkdir build && cd build\ncmake ..\nmake\n```\n"


def _files(needs: str, cmake: str, page: str = "") -> dict[str, str]:
    cmake = f"cmake_minimum_required(VERSION 3.5)\nproject(arm)\n{cmake}\nadd_executable(arm arm.cpp)\n"
    code = {"arm.cpp": "#include <Eigen/Core>\nint main() { return 0; }\n", "README.md": page or "# Arm\n"}
    return {"package.xml": PACKAGE.format(needs), "CMakeLists.txt": cmake, **code}


@pytest.mark.parametrize(
    ("needs", "cmake", "page"),
    [
        (BESIDE, "find_package(srdfdom REQUIRED)", ""),
        (BESIDE, "find_package(srdfdom REQUIRED)", PAGE),
        (OLD, "find_package(urdf REQUIRED)", ""),
        (BESIDE + MSGS, "", ""),
        ("", "find_package(roslib REQUIRED)", ""),
    ],
)
def test_a_package_that_needs_what_only_ros_releases(tree: Tree, needs: str, cmake: str, page: str) -> None:
    decision = tree(_files(needs, cmake, page))
    assert (decision.kind, decision.build_tool) == ("ros1", "catkin_tools")


@pytest.mark.parametrize(
    ("needs", "cmake", "page"),
    [
        (BESIDE, "find_package(Eigen3 REQUIRED)", ""),
        (f"{BESIDE}<depend>fcl</depend><depend>eigen</depend>", "find_package(fcl REQUIRED)", ""),
        ("", "find_package(srdfdom REQUIRED)", ""),
        ("", "find_package(roslib QUIET)", ""),
        (FOR_ROS_1, "find_package(urdf REQUIRED)", ""),
        (BESIDE + MSGS, "", PAGE),
    ],
)
def test_a_library_that_a_workspace_may_hold_is_built_without_ros(
    tree: Tree, needs: str, cmake: str, page: str
) -> None:
    assert tree(_files(needs, cmake, page)).kind == "cpp"


def test_what_ubuntu_has_under_its_own_name_does_not_choose_an_old_distribution(tree: Tree) -> None:
    decision = tree(_files(f"{BESIDE}<depend>dartsim</depend>", "find_package(roslib REQUIRED)\nfind_package(DART)"))
    assert decision.ros_distro == "noetic"
    assert "libdart-dev" in decision.apt_guessed
