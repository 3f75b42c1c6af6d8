"""Programs of Python whose names have no ending: nodes and commands, which their first line tells."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.python.modules import modules
from roslab.evidence.python.through_modules import of_tree
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
NODE = "import torch\nimport rospy\n\nif __name__ == '__main__':\n    rospy.init_node('mapper')\n"
FILES = {
    "package.xml": "<package format='2'><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "find_package(catkin REQUIRED)\ncatkin_package()\n",
    "README.md": "ROS noetic\n",
}


def test_a_node_without_an_ending_is_read(tree: Tree) -> None:
    found = tree({**FILES, "scripts/mapper": f"#!/usr/bin/env python\n{NODE}"})
    assert "python-is-python3" in found.apt_guessed
    assert "torch" in [each.key for each in found.pip]


def test_a_framework_of_such_a_node_is_not_called_one_of_code_beside_them(tree: Tree) -> None:
    found = tree({**FILES, "scripts/mapper": f"#!/usr/bin/env python3\n{NODE}", "scripts/field.py": "import torch\n"})
    assert not [each for each in found.warnings if "nothing asks for torch" in each.message]


@pytest.mark.parametrize(
    ("path", "first", "read"),
    [
        ("bin/tool", "#!/usr/bin/env python3", True),
        ("bin/tool", "#!/usr/bin/python2.7", True),
        ("bin/tool", "#! /usr/bin/env -S python3 -u", True),
        ("bin/tool", "#!/opt/conda/bin/python", True),
        ("bin/tool", "#!/bin/bash", False),
        ("bin/tool", "#!/usr/bin/env pythonista", False),
        ("bin/tool", "# python", False),
        ("bin/tool.in", "#!/usr/bin/env python3", False),
        (".githooks/pre-commit", "#!/usr/bin/env python3", False),
        ("third_party/bin/tool", "#!/usr/bin/env python3", False),
        ("docs/tool", "#!/usr/bin/env python3", False),
    ],
)
def test_the_first_line_tells_python(tmp_path: Path, path: str, first: str, *, read: bool) -> None:
    found = modules(tree_of(tmp_path, {path: f"{first}\nimport numpy\n"}))
    assert [each.file.path for each in found] == ([path] if read else [])


def test_nothing_imports_such_a_program(tmp_path: Path) -> None:
    files = {"numeric": "#!/usr/bin/env python3\nimport scipy\n", "main.py": "import numeric\n"}
    assert of_tree(tree_of(tmp_path, files)).graph.imports("main.py", None) == ()
