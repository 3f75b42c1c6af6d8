"""A program that prints without end fills no disk."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from roslab.prove.said import kept

PRINTS = "import sys; [sys.stdout.write(f'{n:09}\\n') for n in range({count})]"


@pytest.mark.parametrize("count", [0, 5, 10, 15, 100_000])
def test_the_beginning_and_the_end_are_kept(tmp_path: Path, count: int) -> None:
    command = [sys.executable, "-c", PRINTS.replace("{count}", str(count))]
    log = tmp_path / "log"
    with subprocess.Popen(command, stdout=subprocess.PIPE) as process, kept(process, log, head=100, tail=50):
        pass
    lines = [f"{number:09}" for number in range(count)]
    assert log.read_text().split() == (lines if count <= 15 else [*lines[:10], *lines[-5:]])
