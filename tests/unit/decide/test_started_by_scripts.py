"""ROS packages that shell scripts of the tree start."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
ROS1 = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "README.md": "For ROS Noetic.\n",
}


@pytest.mark.parametrize(
    ("script", "asked"),
    [
        ("sudo chmod a+rw /dev/ttyACM0\nrosrun rosserial_python serial_node.py _port:=/dev/ttyACM0\n", True),
        ("gnome-terminal -- roslaunch --wait rosserial_python serial.launch\n", True),
        ("# rosrun rosserial_python serial_node.py\n", False),
        ("rosrun lost_python serial_node.py\n", False),
        ("roslaunch rosserial_python.launch\n", False),
        ("echo rosserial_python\n", False),
        ('echo "rosrun rosserial_python serial_node.py"\n', False),
        ('echo "start" && rosrun rosserial_python serial_node.py\n', True),
        ("true # then rosrun rosserial_python serial_node.py\n", False),
        ('T="$#"; rosrun rosserial_python serial_node.py\n', True),
    ],
)
def test_one_that_was_released_is_installed(tree: Tree, script: str, asked: bool) -> None:
    decision = tree({**ROS1, "scripts/tabsetup.sh": f"#!/bin/bash\n{script}"})
    found = [name for name in decision.apt_guessed if name.startswith("ros-")]
    assert found == (["ros-noetic-rosserial-python"] if asked else [])


def test_the_trees_own_is_none(tree: Tree) -> None:
    assert not tree({**ROS1, "a.sh": "rosrun demo a\n"}).apt_guessed


def test_every_one_of_a_line(tree: Tree) -> None:
    script = "gnome-terminal --tab -e 'roslaunch gazebo_ros empty_world.launch' --tab -e 'rosrun rviz rviz'\n"
    assert {"ros-noetic-gazebo-ros", "ros-noetic-rviz"} <= {*tree({**ROS1, "a.sh": script}).apt_guessed}
