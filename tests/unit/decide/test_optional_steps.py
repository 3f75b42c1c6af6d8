"""A step that a page calls optional, or that makes the data of the next one, is no default beside the package's own."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROGRAMS = ("add_executable(drift src/a.cpp)", "add_executable(cook src/a.cpp)", "add_executable(plotter src/a.cpp)")
FILES = {
    "package.xml": "<package><name>drift_ros</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "\n".join(("project(drift_ros)", "find_package(catkin REQUIRED)", *PROGRAMS, "catkin_package()")),
    "src/a.cpp": "int main() {}\n",
}
COOK, DRIFT, PLOT = ("rosrun drift_ros " + name for name in ("cook --input raw", "drift [folder]", "plotter"))


def page(first: str, *commands: str) -> str:
    steps = (first, *("Run this:" for _ in commands[1:]))
    return "# Drift\n\n## How to use\n\n" + "\n".join(
        f"{number}. {said}\n\n  ``{command}``\n"
        for number, (said, command) in enumerate(zip(steps, commands, strict=True))
    )


@pytest.mark.parametrize(
    ("said", "commands", "program"),
    [
        ("**Recommended** Reorganize ROS messages by timestamp:", (COOK, DRIFT, PLOT), "drift"),
        ("Sort them (optional):", (COOK, DRIFT), "drift"),
        ("Optionally sort them:", (COOK, DRIFT), "drift"),
        ("Convert the ROS bags:", (COOK, DRIFT), "drift"),
        ("Sort what was recorded:", (COOK, DRIFT), "cook"),
        ("**Recommended** Sort them:", (COOK, PLOT), "cook"),
        ("**Recommended** Measure it:", (DRIFT, COOK), "cook"),
    ],
)
def test_the_packages_own_program_is_before_such_a_step(
    tree: Tree, said: str, commands: tuple[str, ...], program: str
) -> None:
    command = tree({**FILES, "README.md": page(said, *commands)}).command
    assert command[:3] == ("rosrun", "drift_ros", program)


def test_a_block_below_it_is_such_a_step(tree: Tree) -> None:
    text = f"## Usage\n\nOptional: sort them.\n\n```\n{COOK}\n```\n\nRun it:\n\n```\n{DRIFT}\n```\n"
    assert tree({**FILES, "README.md": text}).command[2] == "drift"
    text = text.replace("Optional: sort them.", "Sort them.")
    assert tree({**FILES, "README.md": text}).command[2] == "cook"
