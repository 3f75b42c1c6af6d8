"""Usage texts that go on below their command."""

from __future__ import annotations

import pytest

from roslab.evidence.prose.synopses import with_synopses


@pytest.mark.parametrize(
    ("text", "joined"),
    [
        ("rosrun demo a.py\n    [-h]\n    --map MAP\n    [--show SHOW]", True),
        ("python demo.py\n  [-h] --map MAP\n  FILE", True),
        ("usage: demo.py [-h]\n               [--map MAP]", True),
        ("rosrun demo a.py\n    --map map.csv\n", False),
        ("rosrun demo a.py\n[-h]\n[--map MAP]", False),
        ("rosrun demo a.py\n\n    [-h]\n", False),
        ("rosrun demo a.py\n    and then [it] stops\n", False),
    ],
)
def test_a_command_that_goes_on_below_it(text: str, joined: bool) -> None:
    lines = text.split("\n")
    found = with_synopses(lines)
    assert [line.removesuffix(" \\") for line in found] == lines
    assert [line.endswith(" \\") for line in found] == [joined] * (len(lines) - 1) + [False]
