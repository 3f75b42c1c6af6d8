"""Lines of pages that may hold a command."""

from __future__ import annotations

import pytest

from hanging import ends
from roslab.evidence.prose.telling import telling


@pytest.mark.parametrize("word", ["octave ", "gazebo ", "webots "])
def test_a_long_line_of_one_word(word: str) -> None:
    with ends():
        assert not telling(f".wbt {word * 200_000}")


@pytest.mark.parametrize(
    "line", ["octave --silent main.m", "gazebo worlds/a.world", "git -C demo reset --hard 1234567"]
)
def test_a_command(line: str) -> None:
    assert telling(f"Type {line} there")
