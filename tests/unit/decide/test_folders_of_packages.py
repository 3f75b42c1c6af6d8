"""A script that a page starts in the folder of a package, which ROS finds by its name."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>{}</name><buildtool_depend>catkin</buildtool_depend></package>"
FILES = {
    "planning/explorer/package.xml": PACKAGE.format("explorer"),
    "planning/explorer/CMakeLists.txt": "project(explorer)\nfind_package(catkin REQUIRED)\n",
    "planning/explorer/scripts/start_all.sh": "roslaunch explorer a.launch\n",
    "planning/explorer/launch/a.launch": "<launch/>",
    "other/package.xml": PACKAGE.format("walker"),
    "other/scripts/walk.sh": "roslaunch explorer a.launch\n",
}


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("roscd explorer/scripts && ./start_all.sh", True),
        ("source devel/setup.bash && \\\n    roscd explorer/scripts && \\\n    ./start_all.sh", True),
        ("roscd explorer/scripts\n./start_all.sh", True),
        ("cd ~/catkin_ws\nroscd explorer\n./scripts/start_all.sh", True),
        ("cd $(rospack find explorer)/scripts\n./start_all.sh", True),
        ("cd `rospack find explorer`/scripts && ./start_all.sh", True),
        ("cd $(ros2 pkg prefix explorer)/share/explorer/scripts && ./start_all.sh", True),
        ("roscd walker/scripts && ./walk.sh", True),
        ("roscd elsewhere/scripts && ./start_all.sh", False),
        ("roscd explorer/launch && ./start_all.sh", False),
    ],
)
def test_a_script_is_started_in_the_folder_of_its_package(tree: Tree, page: str, *, command: bool) -> None:
    decision = tree(FILES | {"README.md": f"# Demo\n\nROS Noetic\n\n## Run\n\n```\n{page}\n```\n"})
    started = decision.command if isinstance(decision.command, str) else " ".join(decision.command)
    assert (".sh" in started) is command, started
    if command:
        folder = "other/scripts" if "walker" in page else "planning/explorer"
        assert started.startswith(f"cd {folder}"), started
