"""How a proof's command is told."""

from __future__ import annotations

import pytest

from roslab.proof import LONGEST, Proof, describe


@pytest.mark.parametrize(
    ("command", "told"),
    [
        (("python3", "demo.py", "a b"), "python3 demo.py 'a b'"),
        (("bash", "-c", "roscore & sleep 1\n"), "bash -c 'roscore & sleep 1'"),
        (("python3", "-c", "import os\nprint(1)\n", "a", "b"), "python3 -c 'import os …' a b"),
        ((), "(the image's own command)"),
    ],
)
def test_a_command_is_told_on_one_line(command: tuple[str, ...], told: str) -> None:
    assert describe(Proof(name="x", command=command)) == told


def test_a_long_command_is_cut() -> None:
    told = describe(Proof(name="x", command=("echo", "word" * 100)))
    assert len(told) == LONGEST
    assert told.endswith("…")
