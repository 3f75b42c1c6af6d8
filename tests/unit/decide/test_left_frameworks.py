"""Frameworks that code beside the nodes imports and that an image of ROS goes without."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package format='2'><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "find_package(catkin REQUIRED)\ncatkin_package()\n",
    "README.md": "ROS noetic\n",
    "train.py": "import torch\n",
}


@pytest.mark.parametrize(
    ("listed", "told"),
    [
        ("scipy", True),
        ("ultralytics==8.0.20", False),
        ("timm", False),
        ("torchvision", False),
        ("torch-scatter", False),
        ("flax", False),  # another framework: another way to do the same
    ],
)
def test_what_brings_a_framework_is_no_lack_of_it(tree: Tree, listed: str, told: bool) -> None:
    found = tree({**FILES, "requirements.txt": f"{listed}\n"})
    assert any("nothing asks for torch" in each.message for each in found.warnings) is told


@pytest.mark.parametrize(
    ("page", "asked"),
    [
        ("## Dependencies\n1. pytorch\n2. pybullet\n", ["torch"]),
        ("## Dependencies\n1. pybullet\n", []),
        ("## Dependencies\n1. jax\n", []),  # nothing imports it
        ("## Related\n1. pytorch\n", []),
    ],
)
def test_a_framework_that_a_page_lists_is_asked_for(tree: Tree, page: str, asked: list[str]) -> None:
    found = tree({**FILES, "README.md": f"ROS noetic\n{page}"})
    assert [each.name for each in found.python.pip_guessed] == asked
    assert any("nothing asks for torch" in each.message for each in found.warnings) is not bool(asked)
