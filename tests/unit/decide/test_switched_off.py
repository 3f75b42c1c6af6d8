"""A launch file that can be started without what it includes of a package that nothing brings is started so."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "README.md": "ROS Noetic\n```\nroslaunch demo demo.launch\n```\n",
}
ARGUMENT = '<arg name="simulate" default="true"/>\n'
INCLUDE = (
    '<include if="$(arg simulate)" file="$(find acmesim)/launch/sim.launch"><arg name="gui" value="1"/></include>\n'
)
NODE = '<node pkg="demo" type="a" name="a"/>'


def started(tree: Tree, launch: str, more: dict[str, str] | None = None) -> Decision:
    return tree({**PACKAGE, "launch/demo.launch": f"<launch>\n{launch}{NODE}</launch>", **(more or {})})


def test_the_command_switches_it_off_and_says_so(tree: Tree) -> None:
    decision = started(tree, ARGUMENT + INCLUDE)
    assert decision.command == ("roslaunch", "demo", "demo.launch", "simulate:=false")
    (told,) = [warning for warning in decision.warnings if "acmesim" in warning.message]
    assert "started with simulate:=false, without acmesim" in told.message
    assert (told.file, told.line) == ("launch/demo.launch", 3)


@pytest.mark.parametrize(
    "launch",
    [
        ARGUMENT + INCLUDE + '<param name="a" textfile="$(find acmesim)/a"/>\n',
        ARGUMENT + INCLUDE + '<node pkg="acmesim" type="b" name="b"/>\n',
        ARGUMENT + INCLUDE + '<include file="$(find acmeworld)/launch/world.launch"/>\n',
        ARGUMENT.replace("default", "value") + INCLUDE,
        ARGUMENT + INCLUDE.replace("acmesim", "mavros"),
    ],
)
def test_nothing_is_switched_off_that_does_not_start_the_rest(tree: Tree, launch: str) -> None:
    assert started(tree, launch).command == ("roslaunch", "demo", "demo.launch")


def test_what_a_page_clones_stays_on(tree: Tree) -> None:
    page = f"{PACKAGE['README.md']}```\ngit clone https://github.com/acme/acmesim.git\n```\n"
    decision = started(tree, ARGUMENT + INCLUDE, {"README.md": page})
    assert decision.command == ("roslaunch", "demo", "demo.launch")
