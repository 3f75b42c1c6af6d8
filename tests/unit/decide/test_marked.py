"""What lies in a folder with COLCON_IGNORE or its like is no part of the workspace."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LIST = "- git: {local-name: odd_eigen, uri: https://github.com/lab/odd_eigen.git}\n"


def package(folder: str, needs: str = "roscpp") -> dict[str, str]:
    name = folder.strip("/") or "demo"
    depends = f"<buildtool_depend>catkin</buildtool_depend><depend>{needs}</depend>"
    made = f"project({name})\nfind_package(catkin REQUIRED)\n"
    return {
        f"{folder}package.xml": f"<package format='2'><name>{name}</name>{depends}</package>",
        f"{folder}CMakeLists.txt": made,
    }


HIDDEN = package("c/", "odd_key") | {
    "c/c.rosinstall": LIST,
    "c/launch/c.launch": "<launch/>\n",
    "c/c.py": "import numpy\n",
}


def found(decision: Decision) -> tuple[list[str], list[tuple[str, ...]], bool]:
    """Return what is cloned, what can be started, and whether numpy is installed."""
    starts = [command for command in decision.command_candidates if command != ("bash",)]
    return [s.name for s in decision.source], starts, "python3-numpy" in decision.apt_guessed


@pytest.mark.parametrize("marker", ["AMENT_IGNORE", "CATKIN_IGNORE", "COLCON_IGNORE"])
def test_what_a_marker_hides_needs_and_starts_nothing(tree: Tree, marker: str) -> None:
    hidden = tree(package("a/") | HIDDEN | {f"c/{marker}": ""})
    assert found(hidden) == ([], [], False)
    assert not any("odd" in warning.message for warning in hidden.warnings)


@pytest.mark.parametrize(
    "files",
    [
        package("a/", "odd_eigen") | HIDDEN,
        package("", "odd_eigen") | HIDDEN | {"c/CATKIN_IGNORE": ""},
        package("a/", "odd_eigen") | {"c/c.rosinstall": LIST, "c/CATKIN_IGNORE": ""},
    ],
)
def test_a_list_is_read_where_the_marker_hides_no_package_of_the_workspace(tree: Tree, files: dict[str, str]) -> None:
    """The package around a folder may take it itself; where no package lies is what the sources are cloned to."""
    assert found(tree(files))[0] == ["odd_eigen"]


def test_where_all_is_hidden_the_tree_is_read_as_it_is(tree: Tree) -> None:
    assert tree(HIDDEN | {"c/CATKIN_IGNORE": "", "c/requirements.txt": "numpy\n"}).kind == "python"
