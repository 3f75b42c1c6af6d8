"""Tests of the lab begin when no other command is at work on it: one may still make what they need."""

from __future__ import annotations

import io
import threading
from pathlib import Path

import pytest

from lab import laboratory
from lab.home import lock


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
