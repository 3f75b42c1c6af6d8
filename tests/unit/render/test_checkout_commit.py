"""The script that checks out the commit which a repository records of a submodule, or says what is there instead."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts

SCRIPT = Path(image_scripts.__path__[0]) / "checkout-commit.sh"


def _git(folder: Path, *words: str) -> str:
    identity = ("-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "init.defaultBranch=main")
    return subprocess.run(
        ["git", *identity, *words], cwd=folder, capture_output=True, text=True, check=True
    ).stdout.strip()


def _commit(folder: Path, message: str) -> str:
    _git(folder, "commit", "--quiet", "--allow-empty", "--message", message)
    return _git(folder, "rev-parse", "HEAD")


@pytest.mark.parametrize(
    ("recorded", "served", "taken"),
    [
        ("of the branch", False, "of the branch"),
        ("of no branch", True, "of no branch"),  # as after a forced push; the host still gives it
        ("of no branch", False, "newest"),
        ("gone", True, "newest"),
    ],
)
def test_what_is_taken(tmp_path: Path, recorded: str, served: bool, taken: str) -> None:
    remote = tmp_path / "remote"
    remote.mkdir()
    _git(remote, "init", "--quiet")
    commits = {"of the branch": _commit(remote, "first"), "gone": "0dbfc6e1cb0bd7fc209bee6de83c01b49ac9398a"}
    commits["of no branch"] = _commit(remote, "second")
    _git(remote, "reset", "--quiet", "--hard", commits["of the branch"])
    commits["newest"] = _commit(remote, "third")
    _git(remote, "config", "uploadpack.allowAnySHA1InWant", str(served).lower())
    _git(remote, "config", "protocol.version", "0")
    _git(tmp_path, "clone", "--quiet", remote.as_uri(), "clone")
    _git(tmp_path / "clone", "config", "protocol.version", "0")  # the newer protocol serves any commit
    asked = commits[recorded]
    ran = subprocess.run(["bash", SCRIPT, tmp_path / "clone", asked], capture_output=True, text=True, check=True)
    assert _git(tmp_path / "clone", "rev-parse", "HEAD") == commits[taken]
    said = f"roslab: left out: {remote.as_uri()} has no {asked} any more: {commits[taken]} of main is taken"
    assert (said in ran.stdout) == (taken != recorded)
