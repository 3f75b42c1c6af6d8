"""A tree written to attack, through the steps that need no engine: nothing outside is touched, nothing is forged."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from hostile_tree import BRANCH, COMMANDS, LINKS, MARK, MARKUP, SUBJECT, commands, foreign, gitlinks, listing, write

Roslab = Callable[..., "subprocess.CompletedProcess[str]"]


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """Return a folder with the tree, checked out, what its links lead to, and a runner's folder."""
    write(tmp_path / "tree", tmp_path / "outside")
    who = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
    for words in (["init", "--quiet", f"--initial-branch={BRANCH}"], ["add", "--all", "--force"], *gitlinks(),
                  ["commit", "--quiet", "--message", SUBJECT]):  # fmt: skip
        subprocess.run(["git", "-C", tmp_path / "tree", *who, *words], check=True, capture_output=True)
    for name in ("temp", "home"):
        (tmp_path / name).mkdir()
    return tmp_path


@pytest.fixture
def step(roslab: Roslab, place: Path) -> Callable[..., str]:
    """Return a function that runs one step on the tree, and checks what it says and what it leaves alone."""

    def run(name: str, **environment: str) -> str:
        before = listing(place / "outside", place / "home", place / "tree")
        settings = {
            "HOME": str(place / "home"),
            "GITHUB_ACTIONS": "true",
            "GITHUB_WORKSPACE": str(place / "tree"),
            "GITHUB_OUTPUT": str(place / "outputs"),
            "GITHUB_STEP_SUMMARY": str(place / "summary"),
            "GITHUB_EVENT_NAME": "push",
            "GITHUB_REPOSITORY": "lab/robot",
            "GITHUB_REF": f"refs/heads/{BRANCH}",
            "RUNNER_TEMP": str(place / "temp"),
            **environment,
        }
        answer = roslab("github", name, cwd=place / "tree", env=settings)
        log = answer.stderr + answer.stdout
        assert [said for said in commands(log) if said[1].startswith(MARK) or said[0] not in OURS] == []
        after = listing(place / "outside", place / "home", place / "tree")
        changed = {path for path in {*before, *after} if before.get(path) != after.get(path)}
        own = re.compile(rf"{place}/tree/(\.git/.*|sub|sub/[^/]*)", re.DOTALL)  # git makes submodules' empty folders
        assert {path for path in changed if not own.fullmatch(path)} == set()
        return log

    return run


OURS = {"error", "warning", "notice", "group", "endgroup"}


@pytest.mark.parametrize("config", ["roslab.yaml", "broken.yaml", "base.yaml", "generated.yaml", "wrong.yaml"])
def test_nothing_is_touched_or_forged(place: Path, step: Callable[..., str], config: str) -> None:
    log = step("source")
    assert "sub/ext" in log
    said = step("plan", INPUT_CONFIG=config)
    (folder,) = (place / "temp").glob("roslab-*") if config != "wrong.yaml" else [place / "none"]
    if folder.exists():
        step("summary", ROSLAB_FOLDER=str(folder))
        assert "### ❌ Failed" in (place / "summary").read_text()
    else:
        assert f"file={config}," in said
        assert "### ❌ Nothing was built" in (place / "summary").read_text()
    assert foreign((place / "summary").read_text()) == []


@pytest.mark.parametrize("path", ["bare", "names", "artifact", "../outside", "home"])
def test_a_folder_of_it(place: Path, step: Callable[..., str], path: str) -> None:
    step("source", INPUT_PATH=path)
    step("plan", INPUT_PATH=path)
    if (place / "summary").exists():
        assert foreign((place / "summary").read_text()) == []


@pytest.mark.parametrize("arguments", [["create"], ["create", "--output", "out"], ["create", "--output", "artifact"],
                                       ["inspect"], ["plan"], ["check"]])  # fmt: skip
def test_no_command_writes_through_a_link(roslab: Roslab, place: Path, arguments: list[str]) -> None:
    before = listing(place / "outside", place / "tree")
    answer = roslab(*arguments, cwd=place / "tree", env={"HOME": str(place / "home")})
    after = listing(place / "outside", place / "tree")
    assert {path for path in {*before, *after} if before.get(path) != after.get(path)} == set()
    if arguments[0] == "create":
        assert answer.returncode in {2, 4}


def test_what_the_test_itself_sees(place: Path) -> None:
    """The log and the summary of a program without care: each attack is found, or the tests above mean nothing."""
    stopped = "\n".join(COMMANDS[:9])
    found = commands(f"{stopped}\n::{MARK}::\n" + "\n".join(COMMANDS[9:]))
    assert [name for name, _ in found] == [
        "error", "notice", "set-output", "set-output", "set-env", "save-state", "add-mask", "add-matcher",
        "error", "set-output", "set-env", "add-mask", "command",
    ]  # fmt: skip
    assert commands(f"::stop-commands::t\n::error::{MARK}\n##[error]{MARK}\n::t::\n") == []
    assert len(foreign("\n\n".join(MARKUP))) >= 6
    assert all((place / "tree" / name).is_symlink() for name in LINKS)
