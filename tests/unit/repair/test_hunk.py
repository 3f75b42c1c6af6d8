"""Where two texts differ, as a suggestion in a pull request can say it."""

from __future__ import annotations

import pytest

from roslab.repair.hunk import Hunk, hunk

OLD = "one\ntwo\nthree\n"


@pytest.mark.parametrize(
    ("new", "wanted"),
    [
        ("one\ntwo\nnew\nthree\n", (2, 2, ("two", "new"))),
        ("new\none\ntwo\nthree\n", (1, 1, ("new", "one"))),
        ("one\ntwo\nthree\nnew\n", (3, 3, ("three", "new"))),
        ("one\nnew\nthree\n", (2, 2, ("new",))),
        ("one\nnew\n", (2, 3, ("new",))),
    ],
)
def test_the_only_difference(new: str, wanted: tuple[int, int, tuple[str, ...]]) -> None:
    found = hunk("a", OLD, new)
    assert found == Hunk(file="a", start=wanted[0], end=wanted[1], new=wanted[2])
    lines = OLD.splitlines()
    lines[found.start - 1 : found.end] = found.new
    assert lines == new.splitlines(), "put in the place of those lines it gives the new text"


@pytest.mark.parametrize("new", [OLD, "new\none\ntwo\nthree\nnew\n"])
def test_none_or_several(new: str) -> None:
    assert hunk("a", OLD, new) is None
    assert hunk("a", "", OLD) is None
