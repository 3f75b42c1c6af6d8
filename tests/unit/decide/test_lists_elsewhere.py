"""A list of repositories that lies in another repository is read there, for what is missing."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package format='3'><name>demo</name><export><build_type>ament_cmake</build_type></export>{}</package>"
LISTS = "https://github.com/lab/lists.git"
CLONE = "RUN git clone --branch lab/tool https://github.com/lab/lists.git $HOME/lists\n"
IMAGE = "FROM ros:humble\nARG FILE=tool.https.rosinstall\n{}RUN wstool merge {}\nRUN wstool up\n"


def _lists(tree: Tree, image: str, needs: str = "<depend>tool_msgs_x</depend>") -> list[tuple[str | None, str | None]]:
    files = {
        "package.xml": PACKAGE.format(needs),
        "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
        "Dockerfile.tool": image,
    }
    found = [each for each in tree(files).source if each.prepare]
    assert all("! -path ./tool.https.rosinstall -delete" in each.prepare and each.unasked for each in found)
    return [(each.repo, each.ref) for each in found]


@pytest.mark.parametrize(
    ("image", "found"),
    [
        (IMAGE.format(CLONE, "$HOME/lists/$FILE"), [(LISTS, "lab/tool")]),
        (
            IMAGE.format(CLONE, "${H}/lists/tool.https.rosinstall"),
            [(LISTS, "lab/tool")],
        ),
        (
            IMAGE.format("", "https://raw.githubusercontent.com/lab/lists/v1/tool.https.rosinstall"),
            [(LISTS, "v1")],
        ),
        (IMAGE.format("", "$HOME/lists/$FILE"), []),
        (IMAGE.format(CLONE, "$HOME/other/$FILE"), []),
        (IMAGE.format(CLONE, "$HOME/lists/$OTHER"), []),
    ],
)
def test_the_list_of_another_repository(tree: Tree, image: str, found: list[tuple[str, str]]) -> None:
    assert _lists(tree, image) == found


def test_none_is_read_where_nothing_is_missing(tree: Tree) -> None:
    assert _lists(tree, IMAGE.format(CLONE, "$HOME/lists/$FILE"), "<depend>rclcpp</depend>") == []
