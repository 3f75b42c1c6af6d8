"""Headers in a folder of their package alone are found by code whose CMake does not find the package."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
XML = (
    '<package format="3"><name>map</name><version>1.0.0</version><description>m</description>'
    '<maintainer email="a@example.org">a</maintainer><license>MIT</license>'
    "<buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend>"
    "<export><build_type>ament_cmake</build_type></export></package>\n"
)
CMAKE = (
    "cmake_minimum_required(VERSION 3.8)\nproject(map)\nfind_package(ament_cmake REQUIRED)\n"
    "find_package(rclcpp REQUIRED)\n{}add_executable(a src/a.cpp)\nament_package()\n"
)
AUTO = "find_package(ament_cmake_auto REQUIRED)\nament_auto_find_build_dependencies()\n"
TF2 = "/opt/ros/humble/include/tf2"
CONVERSIONS = f"/opt/ros/humble/include/tf2_geometry_msgs:{TF2}:/opt/ros/humble/include/tf2_ros"


def _variable(tree: Tree, header: str, cmake: str, distribution: str) -> str | None:
    files = {
        "package.xml": XML,
        "CMakeLists.txt": CMAKE.format(cmake)
        if cmake != AUTO
        else CMAKE.format(cmake).replace("rclcpp", "ament_cmake"),
        "src/a.cpp": f"#include <{header}>\nint main() {{}}\n",
        "README.md": f"# Map\n\nFor ROS 2 {distribution.title()}.\n",
    }
    return dict(tree(files).variables).get("CPLUS_INCLUDE_PATH")


@pytest.mark.parametrize(
    ("header", "cmake", "distribution", "value"),
    [
        ("tf2/LinearMath/Transform.h", "", "humble", TF2),
        ("tf2_geometry_msgs/tf2_geometry_msgs.hpp", "", "humble", CONVERSIONS),
        ("tf2/LinearMath/Transform.h", "", "foxy", None),  # all packages' headers are in one folder
        ("tf2/LinearMath/Transform.h", "find_package(tf2 REQUIRED)\n", "humble", None),
        ("tf2/LinearMath/Transform.h", "find_package(tf2_ros REQUIRED)\n", "humble", None),  # it finds tf2
        ("tf2/LinearMath/Transform.h", AUTO, "humble", None),
        ("rclcpp/rclcpp.hpp", "", "humble", None),
        ("fields2cover.h", "find_package(Fields2Cover REQUIRED)\n", "jazzy", "/opt/ros/jazzy/include"),
        ("fields2cover.h", "", "jazzy", None),
        ("other.h", "find_package(Fields2Cover REQUIRED)\n", "jazzy", None),
    ],
)
def test_a_package_of_headers_alone(tree: Tree, header: str, cmake: str, distribution: str, value: str | None) -> None:
    assert _variable(tree, header, cmake, distribution) == value


@pytest.mark.parametrize(
    ("name", "package"),
    [
        ("fields2cover", "ros-jazzy-fields2cover"),
        ("Fields2Cover", "ros-jazzy-fields2cover"),
        ("Nav2-Msgs", "ros-jazzy-nav2-msgs"),
        ("Fields9Cover", None),
    ],
)
def test_a_name_of_cmake_is_a_package_in_another_spelling(tree: Tree, name: str, package: str | None) -> None:
    files = {"package.xml": XML, "CMakeLists.txt": CMAKE.format(f"find_package({name} REQUIRED)\n"), "src/a.cpp": ""}
    decision = tree(files | {"README.md": "For ROS 2 Jazzy.\n"})
    found = {each for each in (*decision.apt, *decision.apt_guessed) if each.startswith("ros-jazzy-")}
    assert found == ({package} if package else set())
    assert any(f"brings {name}," in each.message for each in decision.warnings) == (package is None)


def test_what_the_tree_finds_by_a_file_of_its_own_is_no_package_of_ros(tree: Tree) -> None:
    files = {
        "package.xml": XML,
        "CMakeLists.txt": CMAKE.format("find_package(Fields2Cover REQUIRED)\n"),
        "src/a.cpp": "",
    }
    decision = tree(files | {"README.md": "For ROS 2 Jazzy.\n", "cmake/FindFields2Cover.cmake": "set(A 1)\n"})
    assert not any("fields2cover" in each for each in (*decision.apt, *decision.apt_guessed))
