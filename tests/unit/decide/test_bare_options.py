"""An option whose value the reader fills in goes with it, also one of several values, and ``--ros-args`` itself."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = (
    '<package format="3"><name>demo</name><exec_depend>rclpy</exec_depend>'
    "<export><build_type>ament_python</build_type></export></package>"
)
SETUP = (
    "from setuptools import setup\nsetup(name='demo', packages=['demo'],\n"
    "      entry_points={'console_scripts': ['talk = demo.talk:main']})\n"
)
NODE = {"package.xml": MANIFEST, "setup.py": SETUP, "demo/__init__.py": "", "demo/talk.py": "import rclpy\n"}
TALK = ("ros2", "run", "demo", "talk")


def command(tree: Tree, files: dict[str, str], call: str) -> object:
    return tree({**files, "README.md": f"# Demo\n\nFor ROS 2 Humble.\n\n## Run\n\n```\n{call}\n```\n"}).command


@pytest.mark.parametrize(
    ("said", "kept"),
    [
        ("--ros-args --params-file /path/to/a.yaml", ""),
        ("--ros-args -p file:=xxx/config/a.yaml", ""),
        ("--ros-args -p <name>:=<value> -p <other>:=<value>", ""),
        ("--ros-args --remap image:=<your topic>", ""),
        ("--ros-args ...", ""),
        ("--ros-args -p map := /home/me/a.yaml", ""),
        ("--ros-args -p file:=<path to it> -- --fast", "--fast"),
        ("--ros-args --param file:=<path to it> -r out:=/talk", "--ros-args -r out:=/talk"),
        ("--ros-args -p rate:=1 -p file:=PATH_TO_FILE -p size:=2", "--ros-args -p rate:=1 -p size:=2"),
        ("--ros-args -p rate:=1 --ros-args -p file:=path/to/a", "--ros-args -p rate:=1"),
        ("--ros-args -p rate:=1 --log-level debug", "--ros-args -p rate:=1 --log-level debug"),
    ],
)
def test_of_a_node(tree: Tree, said: str, kept: str) -> None:
    assert command(tree, NODE, f"ros2 run demo talk {said}") == (*TALK, *kept.split())


@pytest.mark.parametrize(
    ("said", "kept"),
    [
        ("--config a.yaml --opts MODEL.WEIGHTS /path/to/a.pth", "--config a.yaml"),
        ("--config a.yaml --opts MODEL.WEIGHTS /path/to/a.pth --fast", "--config a.yaml --fast"),
        ("--config a.yaml --opts MODEL.WEIGHTS /path/to/a.pth TEST.SIZE 1", "--config a.yaml --opts TEST.SIZE 1"),
        ("--opts MODEL.WEIGHTS /path/to/a.pth <more> --config a.yaml", "--config a.yaml"),
        ("--fast -p a.yaml", "--fast -p a.yaml"),
    ],
)
def test_of_a_program(tree: Tree, said: str, kept: str) -> None:
    files = {"run.py": "if __name__ == '__main__':\n    pass\n", "a.yaml": "", "requirements.txt": "numpy\n"}
    assert command(tree, files, f"python run.py {said}") == ("python", "run.py", *kept.split())


def test_roslaunch_lists_arguments_with_the_option_of_that_name(tree: Tree) -> None:
    files = {
        "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
        "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
        "launch/a.launch": "<launch/>\n",
        "README.md": "ROS Noetic\n```\nroslaunch demo a.launch --ros-args\n```\n",
    }
    assert ("roslaunch", "demo", "a.launch", "--ros-args") in tree(files).command_candidates
