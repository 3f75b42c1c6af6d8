"""A key that is one slip away from a known one is told with that, and no repository of its name is looked for."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.ros.slips import meant

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("name", "known"),
    [
        ("rclpp", ("rclcpp", "rclpy")),
        ("roconsole", ("rosconsole",)),
        ("rosconcole", ("rosconsole",)),
        ("rosconosle", ("rosconsole",)),
        ("rossconsole", ("rosconsole",)),
        ("rosconsole", ()),
        ("roconsol", ()),
        ("nav3_msgs", ()),
        ("tg", ()),
    ],
)
def test_names_with_one_slip(name: str, known: tuple[str, ...]) -> None:
    assert meant(name, {"rclcpp", "rclpy", "rosconsole", "nav2_msgs", "tf"}) == known


XML = "<package><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend><depend>{}</depend></package>"
GIT = {".git/HEAD": "ref: refs/heads/humble\n", ".git/config": '[remote "origin"]\n\turl = https://github.com/a/arm\n'}


@pytest.mark.parametrize(
    ("key", "asked", "looked", "said"),
    [
        ("rclpp", "rclcpp", False, "is rclcpp or rclpy meant?"),
        ("rclpp", "tf2", True, "is rclcpp or rclpy meant?"),
        ("arm_parts", "rclcpp", True, "correct the name, or"),
    ],
)
def test_a_key_with_a_slip(tree: Tree, key: str, asked: str, looked: bool, said: str) -> None:
    cmake = f"project(arm)\nfind_package(ament_cmake REQUIRED)\nfind_package({asked} REQUIRED)\n"
    decision = tree({"arm/package.xml": XML.format(key), "arm/CMakeLists.txt": cmake, **GIT})
    assert (f"https://github.com/a/{key}.git" in [source.repo for source in decision.source]) is looked
    assert any(said in each.message and key in each.message for each in decision.warnings)


@pytest.mark.parametrize(("imported", "looked"), [("rclpy", False), ("yaml", True)])
def test_a_key_with_a_slip_for_what_the_code_imports(tree: Tree, imported: str, looked: bool) -> None:
    files = {"package.xml": XML.format("rcply"), "CMakeLists.txt": "project(arm)\nfind_package(ament_cmake REQUIRED)\n"}
    decision = tree({**files, **GIT, "scripts/move.py": f"import {imported}\n"})
    assert ("https://github.com/a/rcply.git" in [each.repo for each in decision.source]) == looked
