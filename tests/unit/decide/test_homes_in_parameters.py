"""A path of the author's computer in a parameter file that the default command loads is told."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "README.md": "ROS Noetic\n```\nroslaunch demo demo.launch\n```\n",
}
LOAD = '<rosparam command="load" file="$(find demo)/param/config.yaml"/>'


@pytest.mark.parametrize(
    ("parameters", "load", "line"),
    [
        ('a: 1\nmap_folder: "/home/somebody/ws/src/demo/map"\n', LOAD, 2),
        ("map_folder: /Users/somebody/map\n", LOAD, 1),
        ("# map_folder: /home/somebody/map\n", LOAD, None),
        ("map_folder: $(find demo)/home/map/a\n", LOAD, None),
        (
            "map_folder: /home/somebody/map\n",
            f'<arg name="b" default="false"/><group if="$(arg b)">{LOAD}</group>',
            None,
        ),
        ("map_folder: /home/somebody/map\n", "", None),
    ],
)
def test_it_is_told_where_the_file_is_loaded(tree: Tree, parameters: str, load: str, line: int | None) -> None:
    launch = f'<launch>{load}<node pkg="demo" type="a" name="a"/></launch>\n'
    decision = tree(FILES | {"launch/demo.launch": launch, "param/config.yaml": parameters})
    told = [(w.file, w.line) for w in decision.warnings if "a path of its author's computer" in w.message]
    assert told == ([("param/config.yaml", line)] if line else [])
