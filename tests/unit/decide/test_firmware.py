"""Code for a microcontroller beside the robot's asks for nothing that the image could have."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = (
    '<package format="3"><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>'
    "<export><build_type>ament_cmake</build_type></export></package>"
)


@pytest.mark.parametrize(
    ("code", "told"),
    [
        ("import machine\nimport utime\nimport network\n", []),
        ("from machine import Pin\nimport unknown_thing\n", ["unknown_thing"]),
        ("import network\n", ["network"]),
    ],
)
def test_its_modules_are_not_told(tree: Tree, code: str, told: list[str]) -> None:
    files = {
        "README.md": "# ROS 2 Humble\n",
        "demo/package.xml": MANIFEST,
        "demo/CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
        "firmware/main.py": code,
    }
    messages = [w.message for w in tree(files).warnings if "no table knows" in w.message]
    assert [name for name in ("machine", "utime", "network", "unknown_thing") if name in " ".join(messages)] == told
