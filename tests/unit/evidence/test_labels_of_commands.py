"""What stands before a command in a block of code: a shell's prompt, a number, the word for a terminal."""

from __future__ import annotations

import pytest

from roslab.values.prompt import typed

RUN = "roslaunch demo run.launch"


@pytest.mark.parametrize(
    "label",
    [
        "\u7ec8\u7aef1\uff1a",
        "\u7b2c\u4e00\u4e2a\u7ec8\u7aef: ",
        "1\u3001",
        "\uff082\uff09",
        "\u2460 ",
        "\u279c ",
        "\u279c  ~ ",
        "\u279c  ws git:(main) \u2717 ",
        "\u276f ",
    ],
)
def test_a_label_is_no_part_of_the_command(label: str) -> None:
    assert typed(label + RUN, block=True) == RUN
    assert typed(label + RUN) == label + RUN


@pytest.mark.parametrize(
    "line", ["\u6570\u636e\uff1a1 2 3", "\u8def\u5f84\uff1a\u7528\u6237", RUN, "python \u8bad\u7ec3.py"]
)
def test_other_lines_stay(line: str) -> None:
    assert typed(line, block=True) == line
