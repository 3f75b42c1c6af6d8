"""Packages that many start and nobody released are looked for where they are known to be, before any guess."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>{}</buildtool_depend>{}</package>"


def _files(tool: str, *names: str) -> dict[str, str]:
    asked = "".join(f"<depend>{name}</depend>" for name in names)
    found = f"find_package({tool} REQUIRED)\n"
    return {"package.xml": PACKAGE.format(tool, asked), "CMakeLists.txt": f"project(demo)\n{found}"}


@pytest.mark.parametrize(
    ("tool", "page", "held"),
    [("catkin", "ROS Noetic\n", ("map_generator", "so3_control")), ("ament_cmake", "ROS Humble\n", None)],
)
def test_the_table_names_where_they_are(tree: Tree, tool: str, page: str, held: tuple[str, ...] | None) -> None:
    decision = tree(_files(tool, "so3_control", "map_generator", "swarm_bridge_x") | {"README.md": page})
    holding = {each.name: each.holding for each in decision.source}
    assert holding.get("ego-planner") == held


def test_every_clone_is_asked_for_all_that_is_missing(tmp_path: Path) -> None:
    page = "# Demo\n\n```\ngit clone https://github.com/lab/things.git\n```\n"
    files = {f"demo/{name}": text for name, text in _files("catkin", "so3_control", "swarm_bridge_x").items()}
    for name, text in (files | {"README.md": "ROS Noetic\n", "demo/README.md": page}).items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    text = dockerfile(plan_repository(tmp_path).plan)
    assert "/ws/src/ego-planner so3_control --also swarm_bridge_x" in text


def test_what_launch_files_alone_start_is_looked_for_there(tree: Tree) -> None:
    launch = '<launch><node pkg="so3_control" type="a" name="a"/><node pkg="map_generator" type="b" name="b"/></launch>'
    files = _files("catkin") | {"README.md": "ROS Noetic\n", "launch/a.launch": launch, "launch/b.launch": launch}
    holding = {each.name: set(each.holding) for each in tree(files).source}
    assert holding == {"ego-planner": {"so3_control", "map_generator"}}
