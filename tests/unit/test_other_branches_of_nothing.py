"""A branch that holds a page alone: the error names the branches that have the code."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from roslab.errors import NothingToBuildError
from roslab.pipeline import plan_repository

PAGE = (
    "# Detector\nThis is not the branch that you look for.\n\n## Versions\nSee the branches:\n\n* `depth`: by depth\n"
    "* `cnn`: learnt\n\n## Licence\nSee `LICENSE` and `other`.\n"
)


def hint(folder: Path, page: str = PAGE) -> str:
    (folder / "README.md").write_text(page)
    with pytest.raises(NothingToBuildError) as error:
        plan_repository(folder)
    return error.value.problems[0].hint or ""


def test_those_of_the_page(tmp_path: Path) -> None:
    said = hint(tmp_path)
    assert said.startswith("the code may be on another branch: depth, cnn; check it out (`git checkout depth`)")
    assert "`ref: depth`" in said


def test_those_of_git_and_of_the_page_first(tmp_path: Path) -> None:
    def git(*words: str) -> None:
        subprocess.run(["git", "-C", str(tmp_path), *words], check=True, capture_output=True)

    git("init", "-q", "-b", "main")
    git("-c", "user.name=a", "-c", "user.email=a@example.org", "commit", "-q", "--allow-empty", "-m", "a")
    for name in ("another", "cnn"):
        git("update-ref", f"refs/remotes/origin/{name}", "HEAD")
    assert hint(tmp_path).startswith("the code may be on another branch: cnn, another; ")


def test_a_page_without_branches(tmp_path: Path) -> None:
    assert hint(tmp_path, "# Demo\nSee `depth`.\n").startswith("is this the root of the repository?")
