"""A case of tests/cases that a stand-in has everything for, built and seen to do what its ``verify`` says.

The others need a code host, Python 2, conda's channels or minutes: their golden files stand for them.
"""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from golden_files import CASES

from .laboratory import Laboratory


@pytest.mark.skipif(not shutil.which("Xvfb"), reason="no Xvfb, without which no window can be seen")
def test_a_program_with_a_window(roslab: Callable[..., CompletedProcess[str]], lab: Laboratory, tmp_path: Path) -> None:
    copy = tmp_path / "window"
    shutil.copytree(CASES / "window", copy)
    words = ("--tag", "repro-lab", "--test", "./verify", "--screenshots", tmp_path / "screenshots")
    try:
        answer = roslab("build", copy, *words, env=lab.environment, timeout=600)
        assert answer.returncode == 0, answer.stderr[-8000:]
        assert answer.stdout == "window:repro-lab\n"
        assert "rung 3, shows, holds: a window showed more than one colour" in answer.stderr
        assert sorted(file.name for file in (tmp_path / "screenshots").iterdir()) == [
            "screenshot-linux-amd64-default-command-starts.png",
            "screenshot-linux-amd64-repository-test.png",
        ]
    finally:
        remove = ["docker", "image", "rm", "window:repro-lab"]
        subprocess.run(remove, env=dict(lab.environment), capture_output=True, check=False)
