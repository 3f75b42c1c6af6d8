"""Patterns that wait for their first use."""

from __future__ import annotations

import importlib
import pkgutil
import re
from pathlib import Path

import pytest

import roslab
from roslab.values.pattern import pattern, postponed


def test_it_is_a_pattern() -> None:
    word = pattern(r"(?P<name>\w+)!", re.IGNORECASE)
    for _ in range(2):  # the second use of each method is the compiled pattern's own
        assert word.findall("a! B!") == ["a", "B"]
        assert word.sub("-", "a! b") == "- b"
        found = word.fullmatch("Ab!")
        assert found
        assert found["name"] == "Ab"
    assert word.pattern == r"(?P<name>\w+)!"
    assert word.groups == 1


def test_a_wrong_one_is_told_at_its_first_use() -> None:
    wrong = pattern("(")
    with pytest.raises(re.error):
        wrong.match("(")


def test_what_is_imported_meanwhile_waits_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "some_library.py").write_text("import re\nWORD = re.compile('a+', re.I)\nWRONG = re.compile('(')\n")
    monkeypatch.syspath_prepend(tmp_path)
    at_once = re.compile
    with postponed():
        library = importlib.import_module("some_library")
    assert re.compile is at_once
    assert library.WORD.fullmatch("aA")
    with pytest.raises(re.error):
        library.WRONG.match("(")


def test_every_pattern_of_the_program_can_be_compiled() -> None:
    found_modules = pkgutil.walk_packages(roslab.__path__, "roslab.")
    names = [each.name for each in found_modules if not {"__main__", "probes"} & set(each.name.split("."))]
    kind = type(pattern(""))
    found = [
        value for name in names for value in vars(importlib.import_module(name)).values() if isinstance(value, kind)
    ]
    assert len(found) > 100
    for each in found:
        assert each.pattern is not None
