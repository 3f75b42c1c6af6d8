"""Tests of the lab begin when no other command is at work on it: one may still make what they need."""

from __future__ import annotations

import io
import os
import shutil
import subprocess
import threading
from pathlib import Path

import pytest

from lab import laboratory
from lab.home import lock

ALL = Path(__file__).parents[1] / "all"
PYTHON = """\
#!/bin/bash
echo "$*" >>called
case "$*" in "-m pytest"*) exit {pytest} ;; "tests/lab up") exit {made} ;; esac
"""
"""A stand-in of the environment's Python: the lab does not run yet."""


def test_what_is_at_work_is_waited_for(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("REPRO_LAB_HOME", str(tmp_path))
    waiting = threading.Thread(target=laboratory.wait)
    with lock(io.StringIO()):
        waiting.start()
        waiting.join(0.2)
        assert waiting.is_alive()
    waiting.join(20)
    assert not waiting.is_alive()


def test_where_there_is_no_lab_nothing_is_made(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("REPRO_LAB_HOME", str(tmp_path / "none"))
    laboratory.wait()
    assert not (tmp_path / "none").exists()


@pytest.mark.parametrize(("tests", "made", "code"), [(0, 0, 0), (1, 0, 1), (0, 1, 1)])
def test_all_tests_end_the_lab_that_they_started(tmp_path: Path, tests: int, made: int, code: int) -> None:
    python = tmp_path / ".venv" / "bin" / "python"
    for folder in (python.parent, tmp_path / "tests"):
        folder.mkdir(parents=True)
    python.write_text(PYTHON.format(pytest=tests, made=made))
    python.chmod(0o755)
    shutil.copy(ALL, tmp_path / "tests")
    (tmp_path / "tests" / "setup").touch()
    environment = {name: value for name, value in os.environ.items() if name != "REPRO_VENV"}
    ran = subprocess.run(["bash", tmp_path / "tests" / "all"], env=environment, capture_output=True, check=False)
    called = (tmp_path / "called").read_text().splitlines()
    assert ran.returncode == code, ran.stderr
    assert called.count("tests/lab up") == 1
    assert called[-1] == "tests/lab down"
