"""A launch file that is only named like its package wins nothing where another package has as many."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


def package(name: str, *launches: str, needs: str = "") -> dict[str, str]:
    asked = f"<depend>{needs}</depend>" if needs else ""
    text = f'<package format="2"><name>{name}</name><buildtool_depend>catkin</buildtool_depend>{asked}</package>'
    cmake = f"project({name})\nfind_package(catkin REQUIRED)\nadd_executable({name}_node a.cpp)\n"
    node = f'<launch><node pkg="{name}" type="{name}_node" name="a"/></launch>'
    files = {f"{name}/package.xml": text, f"{name}/CMakeLists.txt": cmake}
    return files | {f"{name}/launch/{launch}": node for launch in launches}


SENSORS = ("pose.launch", "position.launch", "vicon.launch")


@pytest.mark.parametrize(
    ("files", "wins"),
    [
        (package("distort", "distort.launch") | package("updates", *SENSORS), False),
        (package("distort", "distort.launch") | package("updates", *SENSORS[:2]), True),
        (package("distort", "distort.launch") | package("distort_tools", *SENSORS), True),
        (package("distort", "distort.launch", needs="updates") | package("updates", *SENSORS), True),
        (package("distort", "distort.launch") | package("updates", *SENSORS, needs="distort"), True),
        (package("distort", "distort.launch", "a.launch", "b.launch", "c.launch") | package("up", *SENSORS), True),
    ],
)
def test_the_name_alone(tree: Tree, files: dict[str, str], *, wins: bool) -> None:
    decision = tree(files)
    assert (decision.command == ("roslaunch", "distort", "distort.launch")) is wins
    assert wins or decision.command == ("bash",)
    assert ("roslaunch", "distort", "distort.launch") in decision.command_candidates
