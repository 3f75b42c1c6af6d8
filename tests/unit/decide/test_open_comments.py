"""Comments of XML that are never closed: their end is looked for once."""

from __future__ import annotations

import time
from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

MANIFEST = (
    "<package format='2'><name>demo</name><buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend></package>"
)


@pytest.mark.parametrize("name", ["launch/a.launch", "worlds/a.world", "urdf/a.xacro"])
def test_many_that_are_never_closed_take_no_time(tree: Callable[[dict[str, str]], Decision], name: str) -> None:
    begun = "<!-- /home/me/src/demo/a.yaml " if name.endswith(".world") else "<!-- "
    text = '<launch><include file="$(find demo)/a.launch"/>/home/me/libacme.so ' + begun * (240_000 // len(begun))
    files = {"src/demo/package.xml": MANIFEST, "src/demo/CMakeLists.txt": "project(demo)\nfind_package(catkin)\n"}
    began = time.process_time()
    tree({**files, f"src/demo/{name}": text, "README.md": "ROS Noetic\n```\nroslaunch demo a.launch\n```\n"})
    assert time.process_time() - began < 5
