"""Components of catkin: packages of ROS, but for those that are libraries of their own; ament has none."""

from __future__ import annotations

import pytest

from roslab.evidence.lex.cmake import calls
from roslab.evidence.native.cmake_needs import needs


@pytest.mark.parametrize(
    ("component", "namespace"),
    [
        ("Torch", "cmake"),
        ("OpenCV", "cmake"),
        ("Eigen3", "cmake"),
        ("roscpp", "ros"),
        ("opencv", "ros"),
        ("MyMsgs", "ros"),
    ],
)
def test_a_known_library_with_capital_letters_is_one(component: str, namespace: str) -> None:
    (call,) = calls(f"find_package(catkin REQUIRED COMPONENTS {component})\n", frozenset({"find_package"}))
    (asked,) = needs(call, "CMakeLists.txt", None)
    assert (asked.namespace, asked.name, asked.required) == (namespace, component, True)


@pytest.mark.parametrize("name", ["ament_cmake", "ament_cmake_auto", "rosidl_default_generators"])
@pytest.mark.parametrize(
    "words", ["REQUIRED own_word", "REQUIRED COMPONENTS sensor_msgs", "COMPONENTS rclcpp REQUIRED"]
)
def test_what_ament_made_looks_at_no_components(name: str, words: str) -> None:
    (call,) = calls(f"find_package({name} {words})\n", frozenset({"find_package"}))
    assert list(needs(call, "CMakeLists.txt", None)) == []
