"""Entries added to a roslab.yaml: everything else in it stays, and what it is read as afterwards has them."""

from __future__ import annotations

import pytest

from roslab.config.addition import added
from roslab.config.reader import read
from roslab.errors import ConfigurationError

WANTED = {"apt": ("libglog-dev",)}


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (None, "format: 3\napt:\n  - libglog-dev\n"),
        ("", "format: 3\napt:\n  - libglog-dev\n"),
        ("format: 3\nname: robot", "format: 3\nname: robot\napt:\n  - libglog-dev\n"),
        ("format: 3\napt: [git] # tools\n", "format: 3\napt: [git, libglog-dev] # tools\n"),
        (
            "format: 3\napt:\n  - git # for vcs\n  # no more\nname: robot\n",
            "format: 3\napt:\n  - git # for vcs\n  - libglog-dev\n  # no more\nname: robot\n",
        ),
        ("format: 3\napt:\n- git", "format: 3\napt:\n- git\n- libglog-dev"),
        ("format: 3\napt: git\n", "format: 3\napt: [git, libglog-dev]\n"),
        ("format: 3\napt: []\n", 'format: 3\napt: ["libglog-dev"]\n'),
        ("format: 3\napt: [git, libglog-dev]\n", "format: 3\napt: [git, libglog-dev]\n"),
    ],
)
def test_an_entry_is_added_where_its_key_stands(before: str | None, after: str) -> None:
    result = added(before, WANTED)
    assert result == after
    assert "libglog-dev" in read(result).apt
    assert added(result, WANTED) == result


def test_what_yaml_would_take_for_something_else_is_quoted() -> None:
    result = added(None, {"pip": ("numpy<2", "yes"), "build_args": ("-j1",)})
    assert read(result).pip == ("numpy<2", "yes")
    assert read(result).build_args == ("-j1",)


def test_an_old_file_is_migrated_first() -> None:
    with pytest.raises(ConfigurationError, match="today's format"):
        added("base: {ros: noetic}\napt: [git]\n", WANTED)


def test_a_wrong_file_is_not_written_to() -> None:
    with pytest.raises(ConfigurationError):
        added("format: 3\nappt: [git]\n", WANTED)
