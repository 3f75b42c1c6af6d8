"""Debuggers and their symbols that a page or a script installs are for those who look for a fault."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
}


@pytest.mark.parametrize(
    "name",
    [
        "ros-noetic-octomap-server-dbgsym",
        "libc6-dbg",
        "gdb",
        "gdbserver",
        "valgrind",
        "linux-tools-generic",
        "kcachegrind",
        "strace",
        "clang-tidy-6.0",
        "clang-format",
        "lcov",
        "bash-completion",
    ],
)
@pytest.mark.parametrize("file", ["README.md", "install.sh"])
def test_it_is_not_installed(tree: Tree, file: str, name: str) -> None:
    line = f"sudo apt install {name} libglog-dev"
    text = f"ROS Noetic\n```\n{line}\n```\n" if file == "README.md" else f"#!/bin/bash\n{line}\n"
    decision = tree({**FILES, "README.md": "ROS Noetic\n", file: text})
    assert "libglog-dev" in decision.apt_guessed
    assert name not in {*decision.apt, *decision.apt_guessed}


def test_what_starts_a_node_is(tree: Tree) -> None:
    launch = "<launch><node pkg='demo' type='a' launch-prefix='gdb -ex run --args'/></launch>"
    page = "ROS Noetic\n```\nsudo apt install gdb\n```\n"
    assert "gdb" in tree({**FILES, "README.md": page, "launch/a.launch": launch}).apt_guessed


@pytest.mark.parametrize(
    "name", ["libgdbm-dev", "libdw-dev", "libclang-dev", "python3-pudb", "libgoogle-perftools-dev"]
)
def test_what_is_linked_is(tree: Tree, name: str) -> None:
    page = f"ROS Noetic\n```\nsudo apt install {name}\n```\n"
    assert name in tree({**FILES, "README.md": page}).apt_guessed
