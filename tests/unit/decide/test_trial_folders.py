"""Trials in a folder of their own do not compete with the program at the root."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MAIN = "import numpy\nif __name__ == '__main__':\n    print(numpy)\n"


@pytest.mark.parametrize(
    ("files", "command"),
    [
        (("main.py", "debugs/plot.py", "debugs/plots.py"), ("python3", "main.py")),
        (("main.py", "tmp/plot.py"), ("python3", "main.py")),
        (("main.py", "plot/plot.py"), ("bash",)),
        (("main.py", "other.py", "debug/plot.py"), ("bash",)),
        (("debug/plot.py",), ("python3", "debug/plot.py")),
    ],
)
def test_a_trial_is_not_the_program(tree: Tree, files: tuple[str, ...], command: tuple[str, ...]) -> None:
    decision = tree(dict.fromkeys(files, MAIN))
    assert decision.command == command
    named = {reason.answer for reason in decision.reasons}
    assert all(f"python3 {file}" in named for file in files)
