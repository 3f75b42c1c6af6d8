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
