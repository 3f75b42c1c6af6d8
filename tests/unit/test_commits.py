"""The commit of a checkout."""

from __future__ import annotations

import subprocess
from pathlib import Path

from roslab.repository.git import head


def git(folder: Path, *arguments: str) -> str:
    who = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
    command = ["git", "-C", str(folder), *who, *arguments]
    env = {"PATH": "/usr/bin:/bin", "GIT_COMMITTER_DATE": "1600000000 +0000", "HOME": str(folder)}
    return subprocess.run(command, env=env, check=True, capture_output=True, text=True).stdout


def test_its_name_and_time(tmp_path: Path) -> None:
    assert head(tmp_path) == ("", None)
    git(tmp_path, "init", "--quiet")
    assert head(tmp_path) == ("", None)
    git(tmp_path, "commit", "--quiet", "--allow-empty", "--message", "x")
    assert head(tmp_path) == (git(tmp_path, "rev-parse", "HEAD").strip(), 1_600_000_000)


def test_nothing_that_its_configuration_names_is_run(tmp_path: Path) -> None:
    """A partial clone without its commit would fetch it, by any command that its configuration names."""
    git(tmp_path, "init", "--quiet")
    git(tmp_path, "commit", "--quiet", "--allow-empty", "--message", "x")
    trap = tmp_path / "ran"
    for name, value in (
        ("remote.origin.url", f"ext::touch {trap}"),
        ("remote.origin.promisor", "true"),
        ("extensions.partialclone", "origin"),
        ("protocol.ext.allow", "always"),
        ("core.fsmonitor", f"touch {trap}"),
        ("core.pager", f"touch {trap}"),
        ("log.showSignature", "true"),
        ("gpg.program", f"touch {trap}"),
    ):
        git(tmp_path, "config", name, value)
    assert head(tmp_path)[1] == 1_600_000_000
    commit = git(tmp_path, "rev-parse", "HEAD").strip()
    (tmp_path / ".git/objects" / commit[:2] / commit[2:]).unlink()
    subprocess.run(["git", "-C", str(tmp_path), "log", "-1"], capture_output=True, check=False)
    assert trap.exists(), "without care it runs, so the check below means something"
    trap.unlink()
    assert head(tmp_path) == ("", None)
    assert not trap.exists()
