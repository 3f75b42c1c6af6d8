"""A section that needs no hardware is for this machine, and one that does is for another."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.prose.headings import lines_of

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


def test_the_name_of_a_maker_is_no_robot() -> None:
    for title, elsewhere in (("Demo with a real ROBOTIS arm", False), ("Demo with a real robotic arm", True)):
        *_, last = lines_of(f"# Arm\n\n## {title}\n\nrun it")
        assert last.elsewhere == elsewhere
