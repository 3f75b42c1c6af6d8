"""A command of a page below the root goes where its package cannot be compiled, and the build does not stop there."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
DRIVE = "```bash\nroslaunch drive drive.launch\n```\n"
LINKS = "find_package(catkin REQUIRED)\ncatkin_package()\nadd_executable(a a.cpp)\ntarget_link_libraries(a {})\n"


def _package(name: str, cmake: str = "find_package(catkin REQUIRED)\ncatkin_package()\n") -> dict[str, str]:
    return {
        f"{name}/package.xml": f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>",
        f"{name}/CMakeLists.txt": f"project({name})\n{cmake}",
        f"{name}/a.cpp": "int main() {}\n",
        f"{name}/launch/{name}.launch": f'<launch><node pkg="{name}" type="a" name="a"/></launch>\n',
    }


FILES = _package("drive", LINKS.format("MotorCmd")) | _package("plan") | _package("see")


@pytest.mark.parametrize(
    ("files", "command"),
    [
        ({"drive/README.md": DRIVE}, ("bash",)),
        (
            {"drive/README.md": DRIVE, "plan/README.md": "`roslaunch plan plan.launch`\n"},
            ("roslaunch", "plan", "plan.launch"),
        ),
        ({"README.md": f"ROS Noetic\n{DRIVE}"}, ("roslaunch", "drive", "drive.launch")),
        (
            {"drive/README.md": DRIVE, **_package("drive", LINKS.format("pthread"))},
            ("roslaunch", "drive", "drive.launch"),
        ),
    ],
)
def test_a_package_that_links_what_nobody_has(tree: Tree, files: dict[str, str], command: tuple[str, ...]) -> None:
    decision = tree({"README.md": "ROS Noetic\n", **FILES, **files})
    assert decision.command == command
    assert ("drive" in decision.must_build) is ("drive" in " ".join(command))


@pytest.mark.parametrize(("others", "whole"), [(30, True), (40, False)])
def test_what_brings_few_of_a_large_collection_is_not_its_whole(tree: Tree, others: int, whole: bool) -> None:
    files = {path: text for path, text in _package("plan").items() if not path.endswith(".launch")}
    files |= {
        f"plan/launch/n{n}.launch": '<launch><node pkg="plan" type="a" name="a"/></launch>\n' for n in range(others)
    }
    parts = "".join(f'<include file="$(find plan)/launch/n{n}.launch"/>' for n in range(7))
    files["plan/launch/every.launch"] = f"<launch>{parts}</launch>\n"
    run = ("roslaunch", "plan", "every.launch")
    assert (tree({"README.md": "ROS Noetic\n", **files}).command == run) is whole
