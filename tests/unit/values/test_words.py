"""The words of a command as one text, and a command as a line."""

from __future__ import annotations

import pytest

from roslab.values.words import joined, line_of, written


@pytest.mark.parametrize("words", [("run.py", "--task", "pick it  up"), ("a",), (" a b ",), ()])
def test_what_is_joined_is_parted_where_it_was(words: tuple[str, ...]) -> None:
    assert tuple(map(written, joined(words).split())) == words


def test_a_command_as_a_line() -> None:
    assert line_of("a | b") == "a | b"
    assert line_of(("echo", "a b")) == "echo 'a b'"
