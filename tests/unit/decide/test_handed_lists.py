"""Lists of repositories of any name, which pages and scripts hand to wstool, rosinstall or vcs."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
ROSINSTALL = "- git:\n    local-name: deps/wall\n    uri: https://github.com/other/wall.git\n"
REPOS = "repositories:\n  wall:\n    type: git\n    url: https://github.com/other/wall.git\n    version: v1\n"
PACKAGE = {
    "mpc/package.xml": "<package><name>mpc</name><buildtool_depend>catkin</buildtool_depend><depend>wall</depend>"
    "</package>",
    "mpc/CMakeLists.txt": "project(mpc)\nfind_package(catkin REQUIRED COMPONENTS wall)\ncatkin_package()\n",
}


def _page(*commands: str) -> str:
    return "ROS Noetic.\n\n```\n" + "".join(f"{each}\n" for each in commands) + "```\n"


def _cloned(decision: Decision) -> list[str]:
    return [each.repo or "" for each in decision.source if not each.holding]


WALL = ["https://github.com/other/wall.git"]


@pytest.mark.parametrize(
    ("path", "text", "command"),
    [
        (".mpc_https.install", ROSINSTALL, "wstool init .. ./.mpc_https.install"),
        ("dependencies.list", ROSINSTALL, "wstool merge -t src src/mpc/dependencies.list"),
        ("dependencies.list", ROSINSTALL, 'wstool merge -t src "$HERE/dependencies.list"'),
        ("sisters", ROSINSTALL, "rosinstall ~/catkin_ws/src /opt/ros/noetic sisters"),
        ("sisters.txt", REPOS, "vcs import src < src/mpc/sisters.txt"),
        ("sisters.txt", REPOS, "vcs import --input src/mpc/sisters.txt src"),
        ("a/b/c/more.yaml", REPOS, "vcs import < a/b/c/more.yaml"),
        ("a/deps.install", ROSINSTALL, "wstool merge mpc/a/deps.install"),
    ],
)
@pytest.mark.parametrize("where", ["README.md", "install.sh", "Dockerfile"])
def test_a_list_that_is_handed_to_a_tool_is_read(tree: Tree, path: str, text: str, command: str, where: str) -> None:
    files = {**PACKAGE, path: text, "README.md": "ROS Noetic.\n"}
    files[where] = {
        "README.md": _page(command),
        "install.sh": f"#!/bin/sh\n{command}\n",
        "Dockerfile": f"FROM ros:noetic\nRUN cd src && {command}\n",
    }[where]
    assert _cloned(tree(files)) == WALL


@pytest.mark.parametrize(
    ("text", "script"),
    [
        (ROSINSTALL, "# wstool init .. ./.mpc_https.install\n"),  # switched off
        (ROSINSTALL, "cat ./.mpc_https.install\n"),
        (ROSINSTALL, "apt-get install python-rosinstall .mpc_https.install\n"),  # no tool but the name of a package
        ("mpc wall\n", "wstool init .. ./.mpc_https.install\n"),  # no list
        ("", "wstool init .. ./.mpc_https.install\n"),
    ],
)
def test_other_files_are_no_lists(tree: Tree, text: str, script: str) -> None:
    files = {**PACKAGE, ".mpc_https.install": text, "README.md": "ROS Noetic.\n", "install.sh": f"#!/bin/sh\n{script}"}
    assert not _cloned(tree(files))


def test_of_two_files_of_a_name_the_one_of_the_given_path_is_read(tree: Tree) -> None:
    other = ROSINSTALL.replace("wall", "floor")
    files = {**PACKAGE, "a/deps.install": other, "b/deps.install": ROSINSTALL}
    assert _cloned(tree({**files, "README.md": _page("wstool merge $WS/src/mpc/b/deps.install")})) == WALL
