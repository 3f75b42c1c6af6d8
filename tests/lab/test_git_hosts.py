"""Code hosts out of a folder: what git clones from them comes from there. No engine is needed for it."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from . import git_hosts
from .command import LabError
from .home import HERE
from .private_server import SISTER

Git = Callable[..., CompletedProcess[str]]
WHO = ("-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false")


@pytest.fixture
def git(tmp_path: Path) -> Iterator[Git]:
    """Serve a folder with one repository, and return git with the settings of a stand-in."""
    source = tmp_path / "hosts/github.com/Someone/sister"
    source.mkdir(parents=True)
    for name, text in SISTER.items():
        (source / name).write_text(text)
    environment = {**os.environ, "GIT_CONFIG_GLOBAL": os.devnull, "GIT_CONFIG_NOSYSTEM": "1"}
    for words in (["init", "--quiet"], ["add", "--all"], [*WHO, "commit", "--quiet", "--message", "All"]):
        subprocess.run(["git", *words], cwd=source, env=environment, check=True)
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    (tmp_path / "gitconfig").write_text(git_hosts.settings(f"127.0.0.1:{port}"))
    environment["GIT_CONFIG_GLOBAL"] = str(tmp_path / "gitconfig")
    command = [sys.executable, str(HERE / "git_server.py"), str(tmp_path / "hosts"), "127.0.0.1", str(port)]
    server = subprocess.Popen(command, stderr=subprocess.DEVNULL)
    try:
        while not git_hosts.answers(f"127.0.0.1:{port}"):
            assert server.poll() is None
            time.sleep(0.05)
        yield lambda *words: subprocess.run(
            ["git", *words], cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
        )
    finally:
        server.terminate()
        server.wait()


@pytest.mark.parametrize(
    "address",
    ["https://github.com/Someone/sister", "https://github.com/someone/sister.git", "git@github.com:Someone/sister.git"],
)
def test_a_repository_of_the_folder_is_cloned(git: Git, tmp_path: Path, address: str) -> None:
    answer = git("clone", "--depth", "1", address, "copy")
    assert answer.returncode == 0, answer.stderr
    assert (tmp_path / "copy/told").read_text() == SISTER["told"]


def test_one_that_is_not_there_is_not_found(git: Git) -> None:
    answer = git("clone", "https://github.com/Someone/brother", "copy")
    assert answer.returncode == 128
    assert "not found" in answer.stderr


def test_nobody_can_push(git: Git, tmp_path: Path) -> None:
    git("clone", "https://github.com/Someone/sister", "copy")
    answer = git("-C", str(tmp_path / "copy"), "push", "origin", "HEAD:refs/heads/other")
    assert answer.returncode
    assert git("-C", str(tmp_path / "hosts/github.com/Someone/sister"), "branch", "--list", "other").stdout == ""


def test_nothing_changes_where_no_folder_is_given(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.delenv(git_hosts.VARIABLE, raising=False)
    assert git_hosts.environment() == {}
    monkeypatch.setenv(git_hosts.VARIABLE, str(tmp_path / "none"))
    with pytest.raises(LabError, match="is no folder; it has to hold repositories as HOST/OWNER/NAME"):
        git_hosts.environment()
