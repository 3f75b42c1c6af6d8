"""A section that needs no hardware is for this machine, and one that does is for another."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("title", "first"),
    [
        ("Simulation (no hardware)", "sim.py"),
        ("Run without a robot", "sim.py"),
        ("Launch with mock hardware", "sim.py"),
        ("Launch on fake robots", "sim.py"),
        ("Hardware", "plain.py"),
        ("Run on real robots", "plain.py"),
        ("Run on the hardware", "plain.py"),
    ],
)
def test_what_needs_no_robot_is_read(tree: Tree, title: str, first: str) -> None:
    page = f"# Demo\n\n## {title}\n\n```\npython sim.py\n```\n\n## Code\n\n```\npython plain.py\n```\n"
    files = {"README.md": page, "sim.py": "import numpy\n", "plain.py": "import numpy\n", "requirements.txt": "numpy\n"}
    assert tree(files).command == ("python", first)
