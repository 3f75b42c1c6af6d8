"""The reason for a command counts the other programs that are offered beside it."""

from __future__ import annotations

import pytest

from roslab.decide.among import among
from roslab.decide.candidate import Candidate


def found(name: str, *, strong: bool = True) -> Candidate:
    return Candidate(argv=(name,), why="the README runs it", file="README.md", line=1, strong=strong)


@pytest.mark.parametrize(
    ("ours", "offered", "reason"),
    [
        ("a", "a", "the only one: the README runs it"),
        ("ab", "ab", "the README runs it, before 1 other"),
        ("bac", "abc", "the README runs it, and 2 others"),
        ("a", "ab", "the README runs it; 1 other was found beside it"),
        ("", "abc", "the README runs it; 2 others were found beside it"),
    ],
)
@pytest.mark.parametrize("strong", [True, False])
def test_the_others_are_counted(ours: str, offered: str, reason: str, *, strong: bool) -> None:
    all_of_them = [found(name, strong=strong or name in ours) for name in offered]
    assert among(found("a"), [found(name) for name in ours], all_of_them) == reason
