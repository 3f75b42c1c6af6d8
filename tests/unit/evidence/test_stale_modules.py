"""Whether anything of the tree names the folder of a submodule that the commit does not have."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from roslab.evidence.ros.stale_modules import named
from roslab.repository.checkout import Repository


@pytest.mark.parametrize(
    ("file", "text", "expected"),
    [
        ("CMakeLists.txt", "add_subdirectory(lib/fast)\n", True),
        ("CMakeLists.txt", "add_subdirectory(lib/fast-er)\n", False),
        ("README.md", "It is fast.\n", False),
        ("README.md", "It is fast.\nThen cd lib/fast and fast\n", True),
        ("README.md", "fast: pip install it\n", False),
        ("notes.tex", "cd lib/fast\n", False),
    ],
)
def test_a_file_names_the_folder(tmp_path: Path, file: str, text: str, expected: bool) -> None:
    (tmp_path / file).write_text(text, encoding="utf-8")
    assert named(Repository.open(tmp_path), "lib/fast") is expected


def test_many_names_in_long_lines_take_no_time(tmp_path: Path) -> None:
    (tmp_path / "README.md").write_text("install " * 15_000, encoding="utf-8")
    (tmp_path / "other.md").write_text("fast0 " * 20_000, encoding="utf-8")
    repository = Repository.open(tmp_path)
    before = time.process_time()
    assert not any(named(repository, f"lib/fast{number % 50}") for number in range(5_000))
    assert time.process_time() - before < 2
