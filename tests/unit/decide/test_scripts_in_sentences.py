"""A script of the tree that a sentence runs, by its path in the home of who wrote it too."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {"requirements.txt": "numpy\n", "drive.py": "import numpy\n", "scripts/teleop.sh": "python3 drive.py\n"}


@pytest.mark.parametrize(
    ("sentence", "script"),
    [
        ("- Run `./~/arm_ws/scripts/teleop.sh`", True),
        ("Then run `~/arm_ws/scripts/teleop.sh`.", True),
        ("Run the script `./scripts/teleop.sh --fast`", True),
        ("Run `~/arm_ws/src/other/teleop.sh`", False),
        ("Do not edit `~/arm_ws/scripts/teleop.sh`", False),
        ("Run `~/arm_ws/scripts/teleop.sh <robot>`", False),
    ],
)
def test_by_its_path(tree: Tree, sentence: str, script: bool) -> None:
    decision = tree({**FILES, "README.md": f"# Demo\n\n{sentence}\n"})
    assert any("scripts/teleop.sh" in word for word in decision.command) is script
    assert not any("src/other" in word for argv in decision.command_candidates for word in argv)
