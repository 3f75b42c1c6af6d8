"""Programs that CMake makes only outside of a workspace of ROS are none of the package."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.lex.cmake import calls
from roslab.evidence.lex.truth import workspace_holds

Tree = Callable[[dict[str, str]], Decision]
PAGE = "ROS Noetic\n```\nmkdir build && cd build\ncmake .. && make\n./bin/demo_arm can0\n```\n"
SETS = (
    "if(CATKIN_DEVEL_PREFIX)\n  set(PLAIN OFF)\n  find_package(catkin REQUIRED)\n  catkin_package()\n"
    "else()\n  set(PLAIN ON)\nendif()\n"
)


def sdk(cmake: str, sample: str = "add_executable(demo_arm a.cpp)\n", tool: str = "catkin") -> dict[str, str]:
    return {
        "package.xml": f"<package format='2'><name>arm_sdk</name><buildtool_depend>{tool}</buildtool_depend></package>",
        "CMakeLists.txt": f"project(arm_sdk)\n{cmake}add_library(arm_sdk b.cpp)\n",
        "sample/CMakeLists.txt": "add_subdirectory(arm)\n",
        "sample/arm/CMakeLists.txt": sample,
        "README.md": PAGE,
    }


@pytest.mark.parametrize(
    ("cmake", "there"),
    [
        (f"{SETS}if(PLAIN)\n  add_subdirectory(sample)\nendif()\n", False),
        (f"{SETS}if(NOT PLAIN)\n  add_subdirectory(sample)\nendif()\n", True),
        (f"{SETS}add_subdirectory(sample)\n", True),
        (f"{SETS}set(PLAIN ON)\nif(PLAIN)\n  add_subdirectory(sample)\nendif()\n", True),
        ("find_package(catkin)\nif(NOT catkin_FOUND)\n  add_subdirectory(sample)\nendif()\n", False),
        ("find_package(catkin)\nif(catkin_FOUND)\nelse()\n  add_subdirectory(sample)\nendif()\n", False),
        ("find_package(catkin)\nif(catkin_FOUND)\n  add_subdirectory(sample)\nendif()\n", True),
        ("find_package(catkin)\nif(NOT DEFINED ENV{ROS_VERSION})\n  add_subdirectory(sample)\nendif()\n", False),
        ("find_package(catkin)\nif(NOT ament_cmake_FOUND)\n  add_subdirectory(sample)\nendif()\n", True),
        ("find_package(catkin)\nif(SOMETHING)\n  add_subdirectory(sample)\nendif()\n", True),
    ],
)
def test_a_program_outside_of_the_workspace_is_no_program_of_the_package(tree: Tree, cmake: str, there: bool) -> None:
    decision = tree(sdk(cmake))
    assert decision.kind == "ros1"
    run = ("rosrun", "arm_sdk", "demo_arm", "can0")
    assert decision.command == (run if there else ("bash",))
    told = any("demo_arm, which CMake compiles only outside" in warning.message for warning in decision.warnings)
    assert told == (not there)


def test_a_program_that_both_builds_make_stays(tree: Tree) -> None:
    both = f"{SETS}if(PLAIN)\n  add_subdirectory(sample)\nelse()\n  add_executable(demo_arm c.cpp)\nendif()\n"
    assert tree(sdk(both)).command == ("rosrun", "arm_sdk", "demo_arm", "can0")


BOTH = (
    "<package format='3'><name>arm_sdk</name>"
    "<buildtool_depend condition='$ROS_VERSION == 1'>catkin</buildtool_depend>"
    "<buildtool_depend condition='$ROS_VERSION == 2'>ament_cmake</buildtool_depend>"
    "<export><build_type condition='$ROS_VERSION == 1'>catkin</build_type>"
    "<build_type condition='$ROS_VERSION == 2'>ament_cmake</build_type></export></package>"
)
WRAPPED = (
    'project(arm_sdk)\noption(ROS_BUILD "with ROS" {})\nif(ROS_BUILD)\n  find_package(catkin QUIET)\n'
    "  find_package(ament_cmake QUIET)\n  if(catkin_FOUND)\n    include(cmake/ros1.cmake)\n"
    "  elseif(ament_cmake_FOUND)\n    include(cmake/ros2.cmake)\n  else()\n    include(cmake/native.cmake)\n  endif()\n"
    "else()\n  include(cmake/native.cmake)\nendif()\n"
)
BUILD = "ROS 2 Humble\n```\ncolcon build{}\n```\nWithout ROS:\n```\ncmake .. && make\n./demo_arm can0\n```\n"


def wrapped(page: str, default: str) -> dict[str, str]:
    return {
        "package.xml": BOTH,
        "CMakeLists.txt": WRAPPED.format(default),
        "cmake/ros1.cmake": "add_executable(arm_ros1 a.cpp)\n",
        "cmake/ros2.cmake": "add_executable(arm_ros2 a.cpp)\ninstall(TARGETS arm_ros2 DESTINATION lib/arm_sdk)\n",
        "cmake/native.cmake": "add_executable(demo_arm b.cpp)\n",
        **dict.fromkeys(("a.cpp", "b.cpp"), "#include <Eigen/Dense>\nint main() {}\n"),
        "README.md": page,
    }


@pytest.mark.parametrize(
    ("args", "default", "there"),
    [
        (" --cmake-args -DROS_BUILD=ON", "OFF", False),
        (" --cmake-args -DROS_BUILD:BOOL=1", "OFF", False),
        ("", "OFF", True),
        (" --cmake-args -DROS_BUILD=OFF", "OFF", True),
        (" --cmake-args -DOTHER=ON", "OFF", True),
    ],
)
def test_a_program_that_waits_for_an_option_to_be_off(tree: Tree, args: str, default: str, there: bool) -> None:
    decision = tree(wrapped(BUILD.format(f"{args}\nros2 run rviz2 rviz2"), default))
    assert decision.kind == "ros2"
    run = ("demo_arm", "can0") if there else ("arm_ros2",)
    assert ("ros2", "run", "arm_sdk", *run) in (decision.command, *decision.command_candidates)
    assert not any({"arm_ros1", *(() if there else ("demo_arm",))} & {*words} for words in decision.command_candidates)
    assert any("demo_arm, which CMake compiles only outside" in w.message for w in decision.warnings) != there


@pytest.mark.parametrize(("args", "there"), [(" --cmake-args -DROS_BUILD=ON", False), ("", True)])
@pytest.mark.parametrize("default", ["OFF", "ON"])
def test_a_program_of_the_branch_of_an_option_that_is_off(tree: Tree, args: str, there: bool, default: str) -> None:
    files = wrapped(BUILD.format(f"{args}\nros2 run rviz2 rviz2"), default)
    files["CMakeLists.txt"] = (
        f'project(arm_sdk)\noption(ROS_BUILD "with ROS" {default})\nif(NOT ROS_BUILD)\n  include(cmake/native.cmake)\n'
        "else()\n  find_package(ament_cmake REQUIRED)\n  include(cmake/ros2.cmake)\nendif()\n"
    )
    decision = tree(files)
    assert (decision.command == ("ros2", "run", "arm_sdk", "demo_arm", "can0")) is there
    assert any("demo_arm, which CMake compiles only outside" in w.message for w in decision.warnings) != there


@pytest.mark.parametrize(
    ("args", "more", "kind"),
    [
        (" --cmake-args -DROS_BUILD=ON", "", "cpp"),
        (" --cmake-args -DROS_BUILD=ON\nros2 run rviz2 rviz2", "", "ros2"),
        ("", "", "ros2"),
    ],
)
def test_a_page_that_runs_only_what_is_made_without_ros(tree: Tree, args: str, more: str, kind: str) -> None:
    page = BUILD.format(args).replace("./demo_arm", f"{more}./demo_arm")
    decision = tree(wrapped(page, "OFF"))
    assert decision.kind == kind
    if kind == "cpp":
        assert decision.command == ("demo_arm", "can0")
        assert not any("only outside" in each.message for each in decision.warnings)


@pytest.mark.parametrize(
    ("condition", "held"),
    [
        ("CATKIN_DEVEL_PREFIX", (True, False)),
        ("DEFINED CATKIN_DEVEL_PREFIX", (True, False)),
        ("NOT (catkin_FOUND)", (False, True)),
        ("NOT catkin_FOUND AND SOMETHING", (False, None)),
        ("catkin_FOUND OR ament_cmake_FOUND", (True, True)),
        ("$ENV{ROS_VERSION} EQUAL 2", (False, True)),
        ("DEFINED ENV{ROS_DISTRO}", (True, True)),
        ("CATKIN_ENABLE_TESTING", (None, None)),
    ],
)
def test_what_a_workspace_decides(condition: str, held: tuple[bool | None, bool | None]) -> None:
    assert (workspace_holds(condition, 1), workspace_holds(condition, 2)) == held


def test_a_variable_of_one_branch_is_the_branchs_condition() -> None:
    text = "if(CATKIN_DEVEL_PREFIX)\nset(A ON)\nset(B OFF)\nendif()\nif(A)\nx(1)\nendif()\nif(NOT B)\nx(2)\nendif()\n"
    found = [call.conditions for call in calls(text, frozenset({"x"}))]
    assert found == [("CATKIN_DEVEL_PREFIX",), ("CATKIN_DEVEL_PREFIX",)]
