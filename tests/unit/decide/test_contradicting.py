"""Requirement files that pin one package to two releases do not go into one call of pip."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
ROS = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "README.md": "ROS Noetic",
}
IMAGE = (
    "FROM ros:noetic\nCOPY b/requirements.txt /root/b/requirements.txt\nRUN pip3 install -r /root/b/requirements.txt\n"
)


@pytest.mark.parametrize(
    ("second", "image", "installed", "later"),
    [
        ("keras==2.1\nimgaug==0.4", "", ["a/requirements.txt"], ["imgaug==0.4"]),
        ("keras==2.1\nimgaug==0.4", IMAGE, ["b/requirements.txt"], ["scipy"]),
        ("keras>=2.1\nimgaug==0.4", "", ["a/requirements.txt", "b/requirements.txt"], []),
        ("keras==2.0.0\nimgaug==0.4", "", ["a/requirements.txt", "b/requirements.txt"], []),
        ("keras==2.1; python_version<'3'", "", ["a/requirements.txt", "b/requirements.txt"], []),
    ],
)
def test_the_other_file_is_installed_where_it_can_be(
    tree: Tree, second: str, image: str, installed: list[str], later: list[str]
) -> None:
    lists = {"a/requirements.txt": "keras==2.0\nscipy\n", "b/requirements.txt": f"{second}\n"}
    decision = tree(ROS | lists | ({"Dockerfile": image} if image else {}))
    assert decision.python.requirements == tuple(installed)
    assert [each.written for each in decision.python.pip_guessed] == later
    told = [each.message for each in decision.warnings if "that one is installed" in each.message]
    assert bool(told) == bool(later)
    assert all("keras==2.1" in each and "keras==2.0" in each for each in told)
