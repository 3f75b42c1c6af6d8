"""The page of a released package that a workspace has a copy of runs nothing for the workspace."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
JOY = ("rosrun", "joy", "joy_node")


def package(name: str, page: str = "", launch: str = "") -> dict[str, str]:
    code = f"project({name})\nfind_package(catkin REQUIRED)\nadd_executable({name}_node a.cpp)\n"
    files = {
        f"{name}/package.xml": f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>",
        f"{name}/CMakeLists.txt": code,
    }
    node = f'<launch><node pkg="{name}" type="{name}_node" name="a"/></launch>'
    files |= {f"{name}/README.md": f"# {name}\n\n```\n{page}\n```\n"} if page else {}
    return files | ({f"{name}/launch/{launch}": node} if launch else {})


COPY = package("joy", "rosrun joy joy_node", "joy.launch")


@pytest.mark.parametrize(
    ("files", "command"),
    [
        ({**COPY, **package("flexy", launch="flexy.launch")}, ("roslaunch", "flexy", "flexy.launch")),
        (
            {**COPY, **package("flexy", launch="a.launch"), **package("arm_plan", launch="b.launch")},
            ("bash",),
        ),
        ({**COPY, **package("flexy"), "README.md": "```\nrosrun joy joy_node\n```\n"}, JOY),
        ({**COPY, **package("flexy", "rosrun flexy flexy_node")}, ("rosrun", "flexy", "flexy_node")),
        (COPY, JOY),  # all that there is
        ({**COPY, **package("usb_cam")}, JOY),  # nothing beside what was released
        ({**COPY, **package("joy_extras")}, JOY),  # published with others of its own
        (
            {**COPY, **package("flexy"), ".git/config": '[remote "origin"]\n\turl = https://github.com/lab/joy.git\n'},
            JOY,
        ),
    ],
)
def test_the_page_of_a_released_package(tree: Tree, files: dict[str, str], command: tuple[str, ...]) -> None:
    git = {".git/HEAD": "ref: refs/heads/a\n"} if ".git/config" in files else {}
    decision = tree({"notes.md": "ROS Noetic\n", **git, **files})
    assert decision.command == command
    assert JOY in decision.command_candidates


@pytest.mark.parametrize(
    ("url", "command"),
    [
        ("<url type='website'>http://wiki.ros.org/joy</url>", ("roslaunch", "flexy", "plan.launch")),
        ("<url>http://www.ros.org/wiki/joy</url>", ("roslaunch", "flexy", "plan.launch")),
        ("<!-- <url type='website'>http://wiki.ros.org/joy</url> -->", ("roslaunch", "joy", "joy.launch")),
        ("<url>http://ros.org/wiki/joy</url>", ("roslaunch", "flexy", "plan.launch")),
        ("<url>http://www.ros.org/wiki/</url>", ("roslaunch", "joy", "joy.launch")),
        ("<url>http://www.ros.org/about</url>", ("roslaunch", "joy", "joy.launch")),
        ("<url type='website'>https://example.org/joy</url>", ("roslaunch", "joy", "joy.launch")),
        ("", ("roslaunch", "joy", "joy.launch")),
    ],
)
def test_a_copy_without_a_page_is_known_by_that_in_the_wiki_of_ros(
    tree: Tree, url: str, command: tuple[str, ...]
) -> None:
    manifest = f"<package><name>joy</name>{url}<buildtool_depend>catkin</buildtool_depend></package>"
    files = package("joy", launch="joy.launch") | {"joy/package.xml": manifest}
    assert tree({"notes.md": "ROS Noetic\n"} | files | package("flexy", launch="plan.launch")).command == command
