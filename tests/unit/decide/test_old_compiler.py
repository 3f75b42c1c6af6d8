"""Code that needs a newer compiler than the Ubuntu of its ROS has."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository

PACKAGE = (
    "<package format='3'><name>demo</name><version>1.0.0</version><description>d</description>"
    "<maintainer email='a@b.c'>a</maintainer><license>MIT</license>"
    "<buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend></package>"
)
CMAKE = "project(demo)\nfind_package(rclcpp REQUIRED)\nadd_executable(demo main.cpp)\nament_package()\n"
FORMAT = "#include <format>\nint main() {}\n"


@pytest.mark.parametrize(
    ("lines", "code", "found"),
    [
        ("base: {ros: humble}\n", FORMAT, True),
        ("base: {ros: jazzy}\n", FORMAT, False),
        ("base: {ros: humble}\n", "#include <span>\nint main() {}\n", False),
        ("base: {ros: humble}\nenv: {CXX: g++-13}\n", FORMAT, False),
        ("base: {ros: humble}\napt: [g++-13]\n", FORMAT, False),
        ("base: {ros: humble}\napt: [g++-12]\n", FORMAT, True),
    ],
)
def test_a_newer_compiler_is_asked_for(tmp_path: Path, lines: str, code: str, found: bool) -> None:
    files = {"package.xml": PACKAGE, "CMakeLists.txt": CMAKE, "main.cpp": code, "roslab.yaml": f"format: 3\n{lines}"}
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    warnings = plan_repository(tmp_path).plan.warnings
    assert any("needs GCC 13" in each.message for each in warnings) == found
