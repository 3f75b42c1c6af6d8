"""A library that only a package of ROS has, and that CMake links by its bare name, is in a folder of ROS."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FIND = "find_package(g2o REQUIRED)\n"


@pytest.mark.parametrize(
    ("lines", "value"),
    [
        (f"{FIND}target_link_libraries(a g2o_core g2o_stuff)\n", "/opt/ros/humble/lib"),
        (f"{FIND}target_link_libraries(a g2o::core)\n", None),
        ("target_link_libraries(a g2o_core)\n", None),
        (f"{FIND}add_library(g2o_mine b.cpp)\ntarget_link_libraries(a g2o_mine)\n", None),
        ("find_package(OpenCV REQUIRED)\ntarget_link_libraries(a opencv_core)\n", None),
    ],
)
def test_the_linker_is_told_the_folder_of_ros(tree: Tree, lines: str, value: str | None) -> None:
    decision = tree(
        {
            "package.xml": "<package format='3'><name>map</name>"
            "<buildtool_depend>ament_cmake</buildtool_depend></package>",
            "CMakeLists.txt": f"project(map)\nfind_package(ament_cmake REQUIRED)\nadd_executable(a a.cpp)\n{lines}"
            "ament_package()\n",
            "a.cpp": "int main() {}\n",
            "README.md": "ROS 2 Humble\n",
        }
    )
    assert dict(decision.variables).get("LIBRARY_PATH") == value


@pytest.mark.parametrize(
    ("find", "page", "value"),
    [
        ("find_package(OpenRAVE REQUIRED)", "ROS Kinetic", "/opt/ros/kinetic/lib"),
        ("find_package(OpenRAVE REQUIRED)", "ROS Noetic", None),  # which has no OpenRAVE
        ("find_package(OMPL REQUIRED)", "ROS Kinetic", None),
    ],
)
def test_names_that_a_configuration_file_gives(tree: Tree, find: str, page: str, value: str | None) -> None:
    files = {
        "package.xml": "<package><name>plan</name><buildtool_depend>catkin</buildtool_depend></package>",
        "CMakeLists.txt": f"project(plan)\nfind_package(catkin REQUIRED)\n{find}\nadd_executable(a a.cpp)\n"
        "target_link_libraries(a ${OpenRAVE_LIBRARIES})\n",
        "a.cpp": "int main() {}\n",
        "README.md": f"{page}\n",
    }
    assert dict(tree(files).variables).get("LIBRARY_PATH") == value
