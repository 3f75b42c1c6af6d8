"""A block that lists the programs which a build makes runs none of them."""

from __future__ import annotations

from pathlib import Path

import pytest

from trees import decided

MADE = (
    "cmake_minimum_required(VERSION 3.16)\nproject(demo)\nadd_executable(find_a a.cpp)\nadd_executable(merge_b a.cpp)\n"
)


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("The following executables will be available:\n```\nfind_a\nmerge_b\n```\n", "bash"),
        ("This makes two programs:\n\n~~~\n  merge_b\n  find_a\n~~~\nEach takes `-h`.\n", "bash"),
        ("Run the executables:\n```\nmerge_b\nfind_a\n```\n", "merge_b"),
        ("The executables are there:\n```\nmerge_b\n```\n", "merge_b"),
        ("The executables are there:\n```\nmerge_b --fast\nfind_a\n```\n", "merge_b"),
        ("Then:\n```\nmerge_b\nfind_a\n```\n", "merge_b"),
        ("The executables:\n```\nmerge_b\nfind_a\n```\nThen\n```\nfind_a --all\n```\n", "find_a"),
    ],
)
def test_the_programs_that_a_build_makes(tmp_path: Path, page: str, command: str) -> None:
    files = {"CMakeLists.txt": MADE, "a.cpp": "int main() {}\n", "README.md": f"# Demo\n{page}"}
    assert decided(tmp_path, files).command[0] == command
