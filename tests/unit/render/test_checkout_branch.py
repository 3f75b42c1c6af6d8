"""The script that checks out a branch, or what has taken its place."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts
from roslab.render.layers.system import BRANCH

SCRIPT = Path(image_scripts.__path__[0]) / "checkout-branch.sh"


def _git(folder: Path, *words: str) -> str:
    identity = ("-c", "user.name=a", "-c", "user.email=a@b.c", "-c", "init.defaultBranch=main")
    return subprocess.run(
        ["git", *identity, *words], cwd=folder, capture_output=True, text=True, check=True
    ).stdout.strip()


@pytest.mark.parametrize(
    ("branches", "asked", "distro", "taken"),
    [
        (["ros2"], "ros2", "humble", "ros2"),
        (["humble"], "ros2", "humble", "humble"),
        (["melodic-devel", "melodic"], "kinetic", "melodic", "melodic-devel"),
        (["other"], "ros2", "humble", "main"),
        ([], "ros2", "", "main"),
        (["humble"], "master", "humble", "main"),
    ],
)
def test_what_is_taken(tmp_path: Path, branches: list[str], asked: str, distro: str, taken: str) -> None:
    remote = tmp_path / "remote"
    remote.mkdir()
    _git(remote, "init", "--quiet")
    _git(remote, "commit", "--quiet", "--allow-empty", "--message", "first")
    for branch in branches:
        _git(remote, "branch", branch)
    _git(tmp_path, "clone", "--quiet", remote.as_uri(), "clone")
    ran = subprocess.run(
        ["bash", SCRIPT, tmp_path / "clone", asked],
        env={k: v for k, v in os.environ.items() if k != "ROS_DISTRO"} | ({"ROS_DISTRO": distro} if distro else {}),
        capture_output=True,
        text=True,
        check=True,
    )
    assert _git(tmp_path / "clone", "rev-parse", "--abbrev-ref", "HEAD") == taken
    told = f"{remote.as_uri()} has no {asked} any more: {taken} is taken"
    assert (told in ran.stdout) == (asked not in {taken, "master"})


def test_a_folder_of_the_branch_s_name(tmp_path: Path) -> None:
    remote = tmp_path / "remote"
    (remote / "ros2").mkdir(parents=True)
    (remote / "ros2" / "a").touch()
    _git(remote, "init", "--quiet")
    _git(remote, "add", ".")
    _git(remote, "commit", "--quiet", "--message", "first")
    _git(remote, "branch", "ros2")
    _git(tmp_path, "clone", "--quiet", remote.as_uri(), "clone")
    subprocess.run(["bash", SCRIPT, tmp_path / "clone", "ros2"], check=True)
    assert _git(tmp_path / "clone", "rev-parse", "--abbrev-ref", "HEAD") == "ros2"


@pytest.mark.parametrize(
    ("ref", "branch"),
    [
        ("ros2", True),
        ("melodic-devel", True),
        ("feature/x", True),
        ("master", True),
        ("v1.2", False),
        ("20230223_git", True),
        ("4.2", False),
        ("release_1_4", False),
        ("a621ff2e56c56c839a6c40418d42c3c254424b5c", False),
        ("846cf3e", False),
    ],
)
def test_which_refs_may_be_gone(ref: str, branch: bool) -> None:
    assert bool(BRANCH.fullmatch(ref)) == branch
