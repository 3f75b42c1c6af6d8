"""Installing what CMake compiled: it is tried, and stops nothing."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts

SCRIPT = Path(image_scripts.__path__[0]) / "install-program.sh"


@pytest.mark.parametrize(
    ("ends", "called"), [(0, ["cmake -P cmake_install.cmake", "ldconfig "]), (1, ["cmake -P cmake_install.cmake"])]
)
def test_what_cannot_be_installed_stops_nothing(tmp_path: Path, ends: int, called: list[str]) -> None:
    log = tmp_path / "called"
    for name, status in (("cmake", ends), ("ldconfig", 0), ("python3", 0)):
        stand_in = tmp_path / name
        words = "" if name == "python3" else f'echo "{name} $*" >>{log}\n'
        stand_in.write_text(f"#!/bin/sh\n{words}exit {status}\n")
        stand_in.chmod(0o755)
    found = subprocess.run(
        ["bash", SCRIPT, tmp_path],
        env={"PATH": f"{tmp_path}:{os.environ['PATH']}"},
        capture_output=True,
        text=True,
        check=True,
    )
    assert log.read_text().splitlines() == called
    assert ("cannot be installed" in found.stderr) == (ends != 0)
