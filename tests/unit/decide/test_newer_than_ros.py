"""A node whose code is of a newer Python than its ROS has is told."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = (
    "<package><name>star</name><buildtool_depend>catkin</buildtool_depend><exec_depend>rospy</exec_depend></package>"
)
NODE = "#!/usr/bin/env python3\nimport rospy\n{}\nrospy.init_node('n')\n"
MATCH = "match a:\n    case 1:\n        pass"


@pytest.mark.parametrize(
    ("code", "distro", "told"),
    [
        (MATCH, "noetic", ["a match statement, which came with Python 3.10; the Python of ROS noetic is 3.8"]),
        ("'a'.removeprefix('b')", "noetic", ["str.removeprefix or removesuffix, which came with Python 3.9"]),
        ("from functools import cached_property", "noetic", []),
        ("from __future__ import annotations\ndef f(a: list[int]): pass", "noetic", []),
        ("def f(a: list[int]): pass", "noetic", ["a type such as list[int] in"]),
    ],
)
def test_what_came_with_a_newer_python(tree: Tree, code: str, distro: str, told: list[str]) -> None:
    files = {"package.xml": MANIFEST, "scripts/node.py": NODE.format(code), "README.md": f"For ROS {distro}.\n"}
    found = [each for each in tree(files).warnings if "the code of a node uses" in each.message]
    assert [each.file for each in found] == ["scripts/node.py"] * len(told)
    assert all(part in each.message for each, part in zip(found, told, strict=True))
