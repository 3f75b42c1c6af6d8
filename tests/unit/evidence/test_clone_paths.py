"""Paths in calls of CMake that mean a clone beside the tree."""

from __future__ import annotations

from pathlib import Path

from roslab.evidence.dependency import GitSource
from roslab.evidence.native import clones
from roslab.repository.checkout import Repository


def test_a_word_that_is_no_path_is_told_at_once(tmp_path: Path) -> None:
    """Its parts can be divided in so many ways that to try each takes years."""
    word = "some-long_name" * 5 + "$<LINK_ONLY:other>"
    lines = f"project(demo)\nadd_subdirectory(extern/mylib)\ntarget_link_libraries(demo {word})\n"
    (tmp_path / "CMakeLists.txt").write_text(lines)
    url = "https://github.com/o/mylib"
    git = GitSource(name="mylib", url=url, ref=None, strength="prose", file="README.md", line=1, kind="clone")
    (found,) = clones.read(Repository.open(tmp_path), [git], ())
    assert (found.name, found.kind) == ("extern/mylib", "inside")
