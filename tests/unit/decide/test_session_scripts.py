"""What scripts of a package call that start its launch files in several terminals is installed, where apt has it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.knowledge.table import rows

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "README.md": "ROS Noetic\n",
    "copter/package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "copter/CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
}
SESSION = 'tmux new-session -d -s demo\nx=$(echo "1 + $i" | bc)\ntmux send-keys "roslaunch demo fly.launch x:=$x" C-m\n'


def _asked(tree: Tree, path: str, script: str) -> set[str]:
    decision = tree(FILES | {path: f"#!/bin/bash\n{script}"})
    assert not {*decision.apt} & {"tmux", "bc", "screen", "git"}
    return {*decision.apt_guessed} & {"tmux", "bc", "screen", "clang", "gnome-terminal"}


def test_it_is_installed_where_apt_has_it(tree: Tree) -> None:
    assert _asked(tree, "copter/scripts/fly.sh", SESSION) == {"tmux", "bc"}


@pytest.mark.parametrize(
    ("path", "script"),
    [
        ("copter/scripts/old/fly.sh", SESSION),
        ("tools/fly.sh", SESSION),
        ("copter/scripts/fly.sh", SESSION.replace("roslaunch demo", "ssh robot")),
        ("copter/scripts/fly.sh", SESSION.replace("tmux", "# tmux")),
        ("copter/scripts/fly.sh", "clang a.c\necho 1 | bc\nroslaunch demo fly.launch\n"),
    ],
    ids=["below", "elsewhere", "no launch file", "comment", "one terminal"],
)
def test_what_other_scripts_call_is_not(tree: Tree, path: str, script: str) -> None:
    assert _asked(tree, path, script) == set()


def test_the_table_says_of_no_program_anything_else() -> None:
    assert {row["session"] for row in rows("programs")} == {"", "terminals", "work"}
