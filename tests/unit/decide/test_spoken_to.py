"""A script that only speaks to what runs already is no program by itself: the page starts something before it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = (
    '<package format="3"><name>robots</name><buildtool_depend>ament_cmake</buildtool_depend>'
    "<depend>nav2_bringup</depend><export><build_type>ament_cmake</build_type></export></package>"
)
FILES = {
    "src/robots/package.xml": MANIFEST,
    "src/robots/CMakeLists.txt": "project(robots)\nfind_package(ament_cmake REQUIRED)\n"
    "install(DIRECTORY launch DESTINATION share/robots)\nament_package()\n",
    "src/robots/launch/two.py": "def generate_launch_description():\n    return LaunchDescription([])\n",
    "src/robots/launch/four.py": "def generate_launch_description():\n    return LaunchDescription([])\n",
}
PAGE = "# ROS 2 Humble\n\n## Quick start\n```bash\n{}\n```\n"
BEFORE = "ros2 launch nav2_bringup tb3_simulation_launch.py headless:=True"
SPEAKS = 'ros2 topic pub --once /initialpose geometry_msgs/Pose \\\n  "{x: 1}" &\nsleep 2\nwait\necho done\n'


def command(tree: Tree, page: str, script: str) -> tuple[str, ...] | str:
    files = {**FILES, "README.md": PAGE.format(page), "poses.sh": f"#!/bin/bash\n{script}"}
    return tree(files).command


@pytest.mark.parametrize(
    ("page", "script", "found"),
    [
        (f"{BEFORE}\n./poses.sh", SPEAKS, tuple(BEFORE.split())),
        (f"{BEFORE}\n./poses.sh", "rosservice call /go\n", tuple(BEFORE.split())),
        (f"{BEFORE}\n./poses.sh", "ros2 action send_goal /go a/action/B {} || exit 1\n", tuple(BEFORE.split())),
        (f"ros2 launch robots four.py\n{BEFORE}\n./poses.sh", SPEAKS, ("ros2", "launch", "robots", "four.py")),
        ("ros2 launch robots four.py\n./poses.sh", SPEAKS, ("ros2", "launch", "robots", "four.py")),
        (f"{BEFORE}\n./poses.sh", f"{SPEAKS}ros2 run robots node\n", ("bash", "poses.sh")),
        (f"{BEFORE}\n./poses.sh", f"python3 poses.py\n{SPEAKS}", ("bash", "poses.sh")),
        ("./poses.sh", SPEAKS, ("bash", "poses.sh")),
        (f"./poses.sh\n{BEFORE}", SPEAKS, ("bash", "poses.sh")),
    ],
)
def test_what_the_script_speaks_to_is_the_command(tree: Tree, page: str, script: str, found: tuple[str, ...]) -> None:
    assert command(tree, page, script) == found


def test_a_package_that_nothing_of_the_tree_asks_for_is_not_started(tree: Tree) -> None:
    page = BEFORE.replace("nav2_bringup", "other_bringup")
    assert "other_bringup" not in command(tree, f"{page}\n./poses.sh", SPEAKS)
