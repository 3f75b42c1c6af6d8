"""What comes from source where the author's Dockerfile is built, and at which commit."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from trees import commit, tree_of

Tree = Callable[[dict[str, str]], Decision]
CLONE = "git clone {} https://github.com/others/shapes.git"
FILES = {
    "package.xml": "<package><name>demo</name><depend>shapes</depend><depend>lines</depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\nadd_executable(demo_node a.cpp)\n",
    "README.md": "## Install\n\n```\ngit clone https://github.com/others/lines.git\n```\n",
}
IMAGE = "FROM ros:noetic\nRUN cd /ws/src && {}\nCOPY . /ws/src/demo\nRUN cd /ws && catkin_make\n"


def committed(folder: Path, step: str, day: str) -> Decision:
    tree_of(folder, FILES | {"Dockerfile": IMAGE.format(step)})
    commit(folder, day)
    return plan_repository(folder).decision


def test_what_its_steps_clone_comes_from_source_and_nothing_else(tree: Tree) -> None:
    assert [each.name for each in tree(FILES).source] == ["lines"]
    decision = tree(FILES | {"Dockerfile": IMAGE.format(CLONE.format("-b 1.2.0"))})
    assert decision.dockerfile
    assert [(each.name, each.ref, each.before) for each in decision.source] == [("shapes", "1.2.0", "")]


@pytest.mark.parametrize(
    ("options", "day", "said"),
    [
        ("--depth 1", "2021-03-04", "without a tag or a commit"),
        ("-b 4.x", "2021-03-04", "at its branch 4.x"),
        ("-b noetic-devel", "2021-03-04", "at its branch noetic-devel"),
        ("-b v1.2.0", "2021-03-04", ""),
        ("--depth 1", "2026-11-20", ""),  # that is nearly the day of the build
    ],
)
def test_old_code_is_told_of_each_clone_of_a_head(tmp_path: Path, options: str, day: str, said: str) -> None:
    decision = committed(tmp_path, CLONE.format(options), day)
    told = [each for each in decision.warnings if "is cloned" in each.message]
    assert [(each.file, each.line) for each in told] == ([("Dockerfile", 2)] if said else [])
    assert all(said in each.message and day in each.message for each in told)
    assert all(not each.before for each in decision.source)
