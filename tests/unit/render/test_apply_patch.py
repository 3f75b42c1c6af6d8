"""The script that applies a patch of the repository to a clone."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

pytestmark = pytest.mark.usefixtures("scripts_on_path")
GIT, PATCH = ("git", "apply"), ("patch", "-p1")


def _run(*words: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(["apply-patch", *map(str, words)], capture_output=True, text=True, check=False)


@pytest.fixture
def clone(tmp_path: Path) -> Path:
    """Return the folder of a clone with one file; a patch of it lies beside the folder."""
    folder = tmp_path / "maps"
    folder.mkdir()
    (folder / "a.txt").write_text("old\n")
    subprocess.run(["git", "init", "--quiet"], cwd=folder, check=True)
    (tmp_path / "new.patch").write_text("--- a/a.txt\n+++ b/a.txt\n@@ -1 +1 @@\n-old\n+new\n")
    return folder


@pytest.mark.parametrize("command", [GIT, PATCH])
def test_a_patch_that_fits(clone: Path, command: tuple[str, ...]) -> None:
    made = _run("--stops", clone, clone.parent / "new.patch", *command)
    assert (made.returncode, (clone / "a.txt").read_text()) == (0, "new\n")
    assert made.stdout.endswith("roslab: new.patch is applied to maps\n")
    again = _run("--stops", clone, clone.parent / "new.patch", *command)
    assert (again.returncode, (clone / "a.txt").read_text()) == (0, "new\n")
    assert again.stdout.endswith("roslab: maps has what new.patch changes already\n")


@pytest.mark.parametrize("command", [GIT, PATCH])
def test_a_patch_that_does_not_fit(clone: Path, command: tuple[str, ...]) -> None:
    (clone / "a.txt").write_text("other\n")
    made = _run(clone, clone.parent / "new.patch", *command)
    assert (made.returncode, (clone / "a.txt").read_text()) == (0, "other\n")
    assert made.stdout.endswith("roslab: left out: new.patch, which does not fit maps\n")
    stopped = _run("--stops", clone, clone.parent / "new.patch", *command)
    assert stopped.returncode == 1
    assert "new.patch does not fit maps: the build stops there" in stopped.stderr
    assert sorted(each.name for each in clone.iterdir()) == [".git", "a.txt"]


def test_a_clone_that_was_left_out(clone: Path) -> None:
    made = _run("--stops", clone.parent / "gone", clone.parent / "new.patch", *GIT)
    assert (made.returncode, "left out: new.patch" in made.stdout) == (0, True)


@pytest.mark.parametrize("command", [GIT, PATCH])
def test_a_patch_of_several_commits(clone: Path, command: tuple[str, ...]) -> None:
    later = "--- a/a.txt\n+++ b/a.txt\n@@ -1 +1 @@\n-new\n+newest\n"
    (clone.parent / "new.patch").write_text((clone.parent / "new.patch").read_text() + later)
    made = _run("--stops", clone, clone.parent / "new.patch", *command)
    assert (made.returncode, (clone / "a.txt").read_text()) == (0, "newest\n"), made.stderr
    assert sorted(each.name for each in clone.iterdir()) == [".git", "a.txt"]


@pytest.mark.parametrize("option", ["--3way", "-3"])
def test_a_patch_that_is_there_already_by_a_merge_of_three(clone: Path, option: str) -> None:
    for words in (("add", "."), ("-c", "user.name=a", "-c", "user.email=a@b.c", "commit", "--quiet", "-m", "old")):
        subprocess.run(["git", *words], cwd=clone, check=True)
    (clone / "a.txt").write_text("new\n")
    whole = subprocess.run(["git", "diff", "--full-index"], cwd=clone, check=True, capture_output=True, text=True)
    (clone.parent / "new.patch").write_text(whole.stdout)
    subprocess.run(["git", "checkout", "--quiet", "."], cwd=clone, check=True)
    made = _run("--stops", clone, clone.parent / "new.patch", *GIT, option)
    assert (made.stdout, (clone / "a.txt").read_text()) == ("roslab: new.patch is applied to maps\n", "new\n")
    again = _run("--stops", clone, clone.parent / "new.patch", *GIT, option)
    assert (again.stdout, again.returncode) == ("roslab: maps has what new.patch changes already\n", 0)
