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
MODEL = '<arg name="model" default="$(env TURTLEBOT3_MODEL)"/>\n<node name="r" pkg="rviz" type="rviz"/>\n'
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
        (MODEL + SPAWN.format("waffle_pi") + SPAWN.format("waffle"), ("waffle_pi", True)),
        (f"{MODEL}<!-- {SPAWN.format('waffle').strip()} -->\n", ("burger", True)),
        (GAZEBO.replace("turtlebot3_gazebo", "turtlebot3_msgs"), (None, False)),
        (GAZEBO.replace("turtlebot3_gazebo", "turtlebot3_description"), (None, False)),
        (SPAWN.format("waffle"), (None, False)),
    ],
)
def test_what_the_launch_files_name_else_the_first(tree: Tree, launch: str, found: tuple[str | None, bool]) -> None:
    assert _decided(tree, launch) == found


@pytest.mark.parametrize(
    ("own", "model", "told"),
    [
        (SPAWN.format("waffle_pi"), "waffle_pi", ""),
        ("", "burger", "the launch files name the models burger, waffle_pi, and the default command stops without"),
        (SPAWN.format("waffle_pi") + SPAWN.format("waffle"), "waffle_pi", "name the models waffle_pi, waffle, and"),
    ],
)
def test_of_several_that_launch_files_name_the_commands_own_is_meant(
    tree: Tree, own: str, model: str, told: str
) -> None:
    page = "```\nroslaunch demo demo.launch\n```\n"
    more = {f"launch/{name}.launch": f"<launch>\n{SPAWN.format(name)}</launch>" for name in ("burger", "waffle_pi")}
    files = {"launch/demo.launch": f"<launch>\n{GAZEBO}{own}{NODE}</launch>", "README.md": f"ROS Noetic\n{page}"}
    decision = tree({**PACKAGE, **files, **more})
    assert dict(decision.variables)["TURTLEBOT3_MODEL"] == model
    said = [each.message for each in decision.warnings if "TURTLEBOT3_MODEL" in each.message]
    assert (told in said[0]) if told else not said


def test_what_a_page_says_is_kept(tree: Tree) -> None:
    page = "```\nexport TURTLEBOT3_MODEL=waffle_pi\nroslaunch demo demo.launch\n```\n"
    assert _decided(tree, GAZEBO + SPAWN.format("burger"), page) == ("waffle_pi", False)


def test_what_the_authors_image_sets_is_kept(tree: Tree) -> None:
    more = {"docker/Dockerfile": "FROM ros:noetic\nENV TURTLEBOT3_MODEL=waffle\n"}
    assert _decided(tree, GAZEBO, **more) == ("waffle", False)


@pytest.mark.parametrize(
    ("path", "text", "found"),
    [
        ("docs/start.md", 'Then `echo "export TURTLEBOT3_MODEL=waffle" >> ~/.bashrc`.\n', ("waffle", False)),
        ("run.sh", "export TURTLEBOT3_MODEL=waffle_pi\n", ("waffle_pi", False)),
        ("run.sh", 'export TURTLEBOT3_MODEL="${TURTLEBOT3_MODEL:-waffle}"\n', ("waffle", False)),
        ("docker-compose.yml", "environment:\n  TURTLEBOT3_MODEL: waffle\n", ("waffle", False)),
        ("launch/a.launch", '<launch><env name="TURTLEBOT3_MODEL" value="waffle"/></launch>\n', ("waffle", False)),
        ("launch/a.launch.py", "os.environ.get('TURTLEBOT3_MODEL', 'waffle')\n", ("waffle", False)),
        ("launch/a.launch.py", "os.environ['TURTLEBOT3_MODEL'] = 'waffle'\n", ("waffle", False)),
        ("launch/a.launch.py", "A(\n'TURTLEBOT3_MODEL',\n    value='waffle')\n", ("waffle", False)),
        ("launch/a.launch.py", "if os.environ['TURTLEBOT3_MODEL'] == 'waffle':\n    pass\n", ("burger", True)),
        ("run.sh", "# export TURTLEBOT3_MODEL=waffle\n", ("burger", True)),
        ("run.sh", "export TURTLEBOT3_MODEL=waffle_house\n", ("burger", True)),
    ],
)
def test_what_the_tree_sets_anywhere(tree: Tree, path: str, text: str, found: tuple[str, bool]) -> None:
    assert _decided(tree, GAZEBO, "```\nroslaunch demo demo.launch\n```\n", **{path: text}) == found


def test_what_a_page_sets_comes_before_what_launch_files_set_and_name(tree: Tree) -> None:
    page = "```\nroslaunch demo demo.launch\n```\n"
    more = {
        "docs/robot.md": "TURTLEBOT3_MODEL=waffle\n",
        "launch/a.launch": '<launch><env name="TURTLEBOT3_MODEL" value="burger"/></launch>\n',
    }
    assert _decided(tree, GAZEBO + SPAWN.format("waffle_pi"), page, **more) == ("waffle", False)


def test_the_warning_names_the_launch_file(tree: Tree) -> None:
    decision = tree({**PACKAGE, "launch/demo.launch": f"<launch>\n{MODEL}</launch>", "README.md": "ROS Noetic\n"})
    told = next(each for each in decision.warnings if "TURTLEBOT3_MODEL" in each.message)
    assert (told.file, told.line) == ("launch/demo.launch", 2)
