"""A page that misspells the tree's package, of which it starts a launch file, means that package."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package><name>object_detection</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(object_detection)\nfind_package(catkin REQUIRED)\nadd_executable(detector a.cpp)\n",
    "launch/start.launch": '<launch><node pkg="object_detection" type="detector" name="a"/></launch>\n',
}


@pytest.mark.parametrize(
    ("written", "command"),
    [
        ("object_detetion start.launch", ("roslaunch", "object_detection", "start.launch")),
        ("object_detection2 start.launch", None),
        ("object_detetion other.launch", None),
    ],
)
def test_its_launch_file_is_the_default_command(tree: Tree, written: str, command: tuple[str, ...] | None) -> None:
    decision = tree(FILES | {"README.md": f"ROS Noetic\n```\nroslaunch {written}\n```\n"})
    first = next(reason for reason in decision.reasons if reason.question == "command" and reason.decisive)
    assert (first.reason == "the only one: the README runs it") is (command is not None)
    assert command is None or decision.command == command


def test_the_slip_is_told(tree: Tree) -> None:
    decision = tree(FILES | {"README.md": "ROS Noetic\n```\nroslaunch object_detetion start.launch\n```\n"})
    (told,) = [warning.message for warning in decision.warnings if "object_detetion" in warning.message]
    assert told == "the README runs object_detetion, and object_detection of the tree is meant: correct the name there"
