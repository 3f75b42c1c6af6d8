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


def _of_ros2(name: str, finds: str = "", starts: str = "") -> dict[str, str]:
    node = f'<launch><node pkg="{starts or name}" exec="a" name="a"/></launch>\n'
    tool, kind = "<buildtool_depend>ament_cmake</buildtool_depend>", "<build_type>ament_cmake</build_type>"
    installs = f"install(TARGETS a DESTINATION lib/{name})\ninstall(DIRECTORY launch DESTINATION share/{name})\n"
    found = f"find_package(ament_cmake REQUIRED)\n{finds}add_executable(a a.cpp)\n"
    return {
        f"{name}/package.xml": f"<package format='3'><name>{name}</name>{tool}<export>{kind}</export></package>",
        f"{name}/CMakeLists.txt": f"project({name})\n{found}{installs}ament_package()\n",
        f"{name}/a.cpp": "int main() {}\n",
        f"{name}/launch/{name}.launch": node,
    }


ROBOT = {
    **_of_ros2("motor", "find_package(makers-sdk REQUIRED)\n"),
    **_of_ros2("robot", starts="motor"),
    **_of_ros2("plan"),
    "README.md": "ROS 2 Humble\n\n## Usage\n```\nros2 launch robot robot.launch\n```\n",
}


@pytest.mark.parametrize(
    ("files", "command"),
    [
        ({"plan/README.md": "## Usage\n```\nros2 launch plan plan.launch\n```\n"}, "plan plan.launch"),
        ({}, "robot robot.launch"),  # no page runs another
        ({"plan/README.md": "## Usage\n```\nros2 launch motor motor.launch\n```\n"}, "robot robot.launch"),
        (_of_ros2("motor"), "robot robot.launch"),
    ],
)
def test_what_starts_a_package_that_is_left_out_comes_after_what_starts_whole(
    tree: Tree, files: dict[str, str], command: str
) -> None:
    decision = tree({**ROBOT, **files})
    assert decision.command == ("ros2", "launch", *command.split())
    stops = [each.message for each in decision.warnings if each.message.startswith("the default command needs motor")]
    assert len(stops) == (command == "robot robot.launch" and "motor" in decision.left_out)
    assert all("left out of the build: it stops there; " in each for each in stops)


def test_roslaunch_starts_the_others(tree: Tree) -> None:
    sdk = "find_package(catkin REQUIRED)\nfind_package(makers-sdk REQUIRED)\ncatkin_package()\n"
    files = {**_package("motor", sdk), **_package("robot"), **_package("plan")}
    files["robot/launch/robot.launch"] = '<launch><node pkg="motor" type="a" name="a"/></launch>\n'
    pages = {
        "README.md": "ROS Noetic\n\n## Usage\n```\nroslaunch robot robot.launch\n```\n",
        "plan/README.md": "## Usage\n```\nroslaunch plan plan.launch\n```\n",
    }
    decision = tree({**files, **pages})
    assert decision.command == ("roslaunch", "robot", "robot.launch")
    assert any("left out of the build: at most a part of it runs; " in each.message for each in decision.warnings)
