"""A launch file that another package of the tree includes is a part of that, whatever its name is."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


def package(name: str, *launches: tuple[str, str]) -> dict[str, str]:
    return {
        f"{name}/package.xml": f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>",
        f"{name}/CMakeLists.txt": f"project({name})\nfind_package(catkin REQUIRED)\n",
        **{f"{name}/launch/{file}": f"<launch>{text}</launch>" for file, text in launches},
    }


def included(package_name: str, name: str) -> str:
    return f'<include file="$(find {package_name})/launch/{name}"/>'


ARM = package("arm_control", ("arm_control.launch", '<node pkg="arm_control" type="a" name="a"/>'))


@pytest.mark.parametrize(
    ("more", "command"),
    [
        (
            package(
                "arm_gazebo",
                ("world.launch", included("arm_control", "arm_control.launch") + included("arm_gazebo", "eye.launch")),
                ("eye.launch", '<node pkg="arm_gazebo" type="b" name="b"/>'),
            ),
            "roslaunch arm_gazebo world.launch",
        ),
        (
            package("arm_gazebo", ("world.launch", included("arm_control", "arm_control.launch"))),
            "roslaunch arm_gazebo world.launch",
        ),
        (
            package("arm_gazebo", ("world.launch", ""), ("eye.launch", included("arm_gazebo", "world.launch"))),
            "roslaunch arm_control arm_control.launch",
        ),
        (
            {"arm_control/launch/slow.launch": f"<launch>{included('arm_control', 'arm_control.launch')}</launch>"},
            "roslaunch arm_control arm_control.launch",
        ),
    ],
    ids=["another package's", "its only one", "of none", "its own package's"],
)
def test_a_part_is_not_the_program(tree: Tree, more: dict[str, str], command: str) -> None:
    assert " ".join(tree({**ARM, **more}).command) == command


def test_two_of_a_name_are_told_apart_by_their_packages(tree: Tree) -> None:
    parts = [(f"{name}.launch", '<node pkg="robot" type="a" name="a"/>') for name in ("eye", "arm", "leg")]
    all_parts = "".join(included("robot", name) for name, _ in parts)
    robot = package("robot", ("run.launch", included("turtlesim", "run.launch") + all_parts), *parts)
    desk = package("desk", ("run.launch", '<node pkg="desk" type="b" name="b"/>'))
    assert " ".join(tree({**robot, **desk}).command) == "roslaunch robot run.launch"
    both = package("both", ("eye.launch", included("robot", "run.launch") + included("desk", "run.launch")))
    assert " ".join(tree({**robot, **desk, **both}).command) == "roslaunch both eye.launch"


TF_DEMO = package("tf_demo", ("tf_demo.launch", '<node pkg="turtlesim" type="a" name="a"/>'))
OTHERS = {**package("planner"), **package("referee"), **package("stopper")}
STARTS = package("tf_demo", ("tf_demo.launch", '<node pkg="planner" type="a" name="a"/>'))


@pytest.mark.parametrize(
    ("files", "command"),
    [
        ({**TF_DEMO, **OTHERS}, "bash"),
        ({**TF_DEMO, **package("planner")}, "roslaunch tf_demo tf_demo.launch"),
        ({**STARTS, **OTHERS}, "roslaunch tf_demo tf_demo.launch"),
        ({**TF_DEMO, **OTHERS, "README.md": "ROS Noetic\n\n    roslaunch tf_demo tf_demo.launch\n"}, None),
    ],
    ids=["of others", "one beside it", "of the tree's", "a page runs it"],
)
def test_a_demonstration_of_others_is_not_the_program(tree: Tree, files: dict[str, str], command: str | None) -> None:
    files = {**files, "tf_demo/launch/b.launch": '<launch><node pkg="tf_demo" type="b" name="b"/></launch>'}
    assert " ".join(tree(files).command) == (command or "roslaunch tf_demo tf_demo.launch")
