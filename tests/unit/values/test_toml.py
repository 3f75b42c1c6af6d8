"""TOML is read in a time that grows with its size alone."""

from __future__ import annotations

import time

import pytest

from roslab.evidence.python.lenient import tables
from roslab.values import toml

SIZE = 200_000
ALLOWED = 2.0
"""Seconds; a reader that takes time by the square of the size takes minutes."""


@pytest.mark.parametrize(
    "key",
    [
        ".".join("a" * (SIZE // 2)),
        " . ".join("a" * (SIZE // 4)),
        '"".' * (SIZE // 3) + "a",
        "'a' . " * (SIZE // 6) + "a",
        "a" * SIZE,
        "a " * (SIZE // 2),
        "a." * 99 + "a " * SIZE,
    ],
    ids=["plain", "spaced", "empty", "quoted", "one", "words", "near"],
)
@pytest.mark.parametrize("written", ["{} = 1\n", "[{}]\nb = 1\n", "b = {{{} = 1}}\n"])
def test_a_long_key_takes_no_long_time(key: str, written: str) -> None:
    start = time.process_time()
    found, why = tables("[project]\nname = 'a'\n[tool.b]\n" + written.format(key) + "[broken\n[tool.c]\nd = 1\n")
    assert time.process_time() - start < ALLOWED
    assert found["project"] == {"name": "a"}
    assert found["tool"]["c"] == {"d": 1}
    assert why is not None


def test_what_is_wrong_with_it_is_told_with_its_line() -> None:
    with pytest.raises(ValueError, match=r"more than 100 parts \(at line 2, column 1\)"):
        toml.parsed("a = 1\n" + "b." * 200 + "c = 1\n")


def test_a_key_of_some_parts_and_long_texts_are_read() -> None:
    text = f"{'a.' * 90}b = 1\nreadme = '{'One sentence. ' * 300}'\nfiles = ['{'1.2.3.4, ' * 200}']\n"
    assert set(toml.parsed(text)) == {"a", "readme", "files"}
