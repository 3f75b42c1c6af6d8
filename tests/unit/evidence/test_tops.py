"""Lines of a page that send the reader to the top of the repository."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.prose import readme
from roslab.evidence.prose.tops import TO_TOP, gone_to
from roslab.repository.checkout import Repository


@pytest.mark.parametrize(
    "line",
    [
        "# Go to the top directory of this repository",
        "# go back to the root of the repo",
        "## From the root folder of the project, run:",
        "1. Then change to the repository root:",
        "In the main directory of our repository:",
        "# cd to the root directory and build",
        "At the top level of this demo repository.",
    ],
)
def test_a_line_that_goes_to_the_top(line: str) -> None:
    assert gone_to(f"cd a\n{line}\ncd b") == f"cd a\n{TO_TOP}\ncd b"


@pytest.mark.parametrize(
    "line",
    [
        "# Go to the root of the workspace",
        "# go to the root directory of your catkin workspace",
        "# The top directory of this repository has two folders",
        "python main.py  # from the root of the repository",
        "From the root of the problem, run:",
        "From the root of the repository, run `make`.",
    ],
)
def test_a_line_that_does_not(line: str) -> None:
    assert gone_to(f"cd a\n{line}\ncd b") == f"cd a\n{line}\ncd b"


def test_each_block_begins_at_the_top(tmp_path: Path) -> None:
    page = "```console\n{top}$ cd parts/one\n$ pip install -e .\n\n{top}$ cd parts/two/lib\n$ pip install -e .\n```\n"
    (tmp_path / "README.md").write_text(page.format(top="# Go to the top directory of this repository\n"))
    found = readme.read(Repository.open(tmp_path)).requirements
    assert [each.written for each in found] == ["parts/one/.", "parts/two/lib/."]
