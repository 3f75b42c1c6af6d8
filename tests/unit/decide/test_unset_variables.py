"""A variable that the default command's launch file cannot do without is told where nothing sets it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
}
NODE = '<node pkg="demo" type="a" name="a"/>'


def told(tree: Tree, launch: str, more: dict[str, str] | None = None) -> list[tuple[str, int]]:
    decision = tree({**PACKAGE, "launch/demo.launch": f"<launch>\n{launch}{NODE}</launch>", **(more or {})})
    assert decision.command == ("roslaunch", "demo", "demo.launch")
    found = [warning for warning in decision.warnings if "needs the variable" in warning.message]
    assert all(warning.file == "launch/demo.launch" and "`env` in roslab.yaml" in warning.message for warning in found)
    return [(warning.message.partition("variable ")[2].partition(",")[0], warning.line or 0) for warning in found]


@pytest.mark.parametrize(
    ("launch", "found"),
    [
        ('<param name="a" value="$(env ROBOT)/a"/>\n', [("ROBOT", 2)]),
        ('<arg name="robot" default="$(optenv ROBOT)"/>\n<group ns="$(arg robot)"/>\n', [("ROBOT", 3)]),
        ('<include ns="$(optenv ROBOT)" file="a.xml"/>\n', [("ROBOT", 2)]),
        ('<arg name="a" default="$(optenv FILE)"/>\n<rosparam file="$(arg a)"/>\n', [("FILE", 3)]),
        ('<arg name="robot" default="$(optenv ROBOT uav1)"/>\n<group ns="$(arg robot)"/>\n', []),
        ('<arg name="robot" default="$(optenv ROBOT)"/>\n<group ns="/$(arg robot)"/>\n', []),
        ('<arg name="robot" default="$(optenv ROBOT)"/>\n<param name="a" value="$(arg robot)"/>\n', []),
        ('<arg name="real" default="0"/><group if="$(arg real)"><param name="a" value="$(env ROBOT)"/></group>\n', []),
        ('<!-- $(env ROBOT) -->\n<param name="a" value="$(env HOME)/$(env ROS_DISTRO)"/>\n', []),
    ],
)
def test_what_nothing_sets(tree: Tree, launch: str, found: list[tuple[str, int]]) -> None:
    assert told(tree, launch) == found


def test_what_is_set_is_not_told(tree: Tree) -> None:
    launch = '<param name="a" value="$(env ROBOT)"/>\n'
    page = {"README.md": "ROS Noetic\n```\nexport ROBOT=uav1\nroslaunch demo demo.launch\n```\n"}
    assert not told(tree, launch, page)


def test_that_of_another_launch_file_is_not_told(tree: Tree) -> None:
    launch = '<param name="a" value="$(env ROBOT)"/>\n'
    assert not told(tree, "", {"launch/other.launch": f"<launch>{launch}</launch>"})
