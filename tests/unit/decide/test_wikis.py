"""Where no page at hand launches anything, a wiki in the tree may say what is launched."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
TREE = {
    "demo/package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "demo/CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "demo/launch/map.launch": "<launch/>",
    "demo/launch/drive.launch": "<launch/>",
    "demo/launch/other.launch": "<launch/>",
}
PAGE = "# Start it\n`roslaunch demo drive.launch`\n"
DRIVE = ("roslaunch", "demo", "drive.launch")


@pytest.mark.parametrize(
    ("pages", "command"),
    [
        ({"wiki/workflow.md": PAGE}, DRIVE),
        ({"demo.wiki/workflow.md": PAGE}, DRIVE),
        ({"docs/workflow.md": PAGE}, ("bash",)),  # nobody links to it
        (
            {"wiki/workflow.md": PAGE, "README.md": "    roslaunch demo map.launch\n"},
            ("roslaunch", "demo", "map.launch"),
        ),
        ({"wiki/faq.md": PAGE}, ("bash",)),
        ({"notes/workflow.md": PAGE}, ("bash",)),
        ({"wiki/workflow.md": PAGE.replace("demo", "nav")}, ("bash",)),
    ],
)
def test_a_page_of_the_wiki_may_launch_a_package(tree: Tree, pages: dict[str, str], command: tuple[str, ...]) -> None:
    assert tree({**TREE, **pages}).command == command
