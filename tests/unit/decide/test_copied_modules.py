"""A module that a tree holds under another name than the one it is imported by comes from the index."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "README.md": "ROS Noetic\n```\nrosrun demo show.py\n```\n",
    "scripts/show.py": "#!/usr/bin/env python3\nimport rospy\nfrom digit_interface.digit import Digit\n",
}


@pytest.mark.parametrize(("copy", "names"), [("src/digit", ["digit-interface"]), ("scripts/digit_interface", [])])
def test_a_copy_counts_by_its_folder(tree: Tree, copy: str, names: list[str]) -> None:
    decision = tree(FILES | {f"{copy}/__init__.py": "", f"{copy}/digit.py": "class Digit: ...\n"})
    assert [asked.key for asked in decision.python.pip_guessed] == names
