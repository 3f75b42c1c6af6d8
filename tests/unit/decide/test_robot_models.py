"""The model of a robot that the default command stops without, where no page says it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
}
MODEL = '<arg name="model" default="$(env TURTLEBOT3_MODEL)"/>\n'
GAZEBO = '<include file="$(find turtlebot3_gazebo)/launch/turtlebot3_world.launch"/>\n'
NODE = '<node name="n" pkg="demo" type="n"/>\n'
SPAWN = '<node name="a" pkg="gazebo_ros" type="spawn_model" args="-urdf -model turtlebot3_{}"/>\n'


def _decided(tree: Tree, launch: str, page: str = "", **more: str) -> tuple[str | None, bool]:
    files = {"launch/demo.launch": f"<launch>\n{launch}{NODE}</launch>", "README.md": f"ROS Noetic\n{page}"}
    decision = tree({**PACKAGE, **files, **more})
    assert decision.command == ("roslaunch", "demo", "demo.launch")
    told = [each.message for each in decision.warnings if "TURTLEBOT3_MODEL" in each.message]
    assert not any("nothing sets" in message for message in told)
    return dict(decision.variables).get("TURTLEBOT3_MODEL"), bool(told)


@pytest.mark.parametrize(
    ("launch", "found"),
    [
        (MODEL, ("burger", True)),
        (GAZEBO, ("burger", True)),
        (MODEL + SPAWN.format("waffle"), ("waffle", False)),
        (MODEL + SPAWN.format("waffle_pi"), ("waffle_pi", False)),
        (MODEL + SPAWN.format("$(arg model)"), ("burger", True)),
        (MODEL + SPAWN.format("waffle_house"), ("burger", True)),
        (MODEL + SPAWN.format("waffle") + SPAWN.format("burger"), ("burger", True)),
        (f"{MODEL}<!-- {SPAWN.format('waffle').strip()} -->\n", ("burger", True)),
        (GAZEBO.replace("turtlebot3_gazebo", "turtlebot3_msgs"), (None, False)),
        (GAZEBO.replace("turtlebot3_gazebo", "turtlebot3_description"), (None, False)),
        (SPAWN.format("waffle"), (None, False)),
    ],
)
def test_what_the_launch_files_name_else_the_first(tree: Tree, launch: str, found: tuple[str | None, bool]) -> None:
    assert _decided(tree, launch) == found


def test_what_a_page_says_is_kept(tree: Tree) -> None:
    page = "```\nexport TURTLEBOT3_MODEL=waffle_pi\nroslaunch demo demo.launch\n```\n"
    assert _decided(tree, GAZEBO + SPAWN.format("burger"), page) == ("waffle_pi", False)


def test_what_the_authors_image_sets_is_kept(tree: Tree) -> None:
    more = {"docker/Dockerfile": "FROM ros:noetic\nENV TURTLEBOT3_MODEL=waffle\n"}
    assert _decided(tree, GAZEBO, **more) == ("waffle", False)
