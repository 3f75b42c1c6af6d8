"""A page that sends the reader to the repository of a workspace names what its author compiles beside this."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

PACKAGE = "<package><name>lab_planner</name><buildtool_depend>catkin</buildtool_depend><depend>{}</depend></package>"
CMAKE = "project(lab_planner)\nfind_package(catkin REQUIRED COMPONENTS {})\ncatkin_package()\n"


def planned(folder: Path, page: str, needs: str = "lab_maps_x") -> tuple[list[tuple[str, str | None, str | None]], str]:
    config = '[remote "origin"]\n\turl = https://github.com/lab/lab_planner\n'
    files = {"package.xml": PACKAGE.format(needs), "CMakeLists.txt": CMAKE.format(needs), "README.md": page}
    tree_of(folder, {**files, ".git/config": config, ".git/HEAD": "ref: refs/heads/main\n"})
    plan = plan_repository(folder).plan
    return [(each.name, each.repo, each.ref) for each in plan.workspace.sources if each.lists], dockerfile(plan)


@pytest.mark.parametrize(
    ("address", "found"),
    [
        ("https://github.com/lab/robots_ws", [("robots_ws", "https://github.com/lab/robots_ws", None)]),
        ("https://github.com/old-lab/lab_planner_ws.git",
         [("lab_planner_ws", "https://github.com/old-lab/lab_planner_ws", None)]),
        ("https://github.com/lab/robots-workspace/tree/noetic",
         [("robots-workspace", "https://github.com/lab/robots-workspace", "noetic")]),
        ("https://github.com/other/robots_ws", []),
        ("https://github.com/lab/news", []),
    ],
)  # fmt: skip
def test_the_page_names_it(tmp_path: Path, address: str, found: list[tuple[str, str | None, str | None]]) -> None:
    page = f"# Planner\n\nROS Noetic\n\nFollow the instructions in [the workspace]({address}) for installation.\n"
    sources, text = planned(tmp_path, page)
    assert sources == found
    assert ("\nRUN take-listed " in text) == bool(found)
    if found:
        assert "--but lab_planner" in text
        assert f"leave-out-failed src/{found[0][0]} -- " in text


def test_nothing_is_missing(tmp_path: Path) -> None:
    page = "# Planner\n\nROS Noetic\n\nSee [the workspace](https://github.com/lab/robots_ws).\n"
    assert planned(tmp_path, page, "roscpp")[0] == []
