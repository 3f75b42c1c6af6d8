"""Requirement files of what was cloned stop no build; the script runs against stand-ins of pip."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts

SCRIPT = Path(image_scripts.__path__[0]) / "install-cloned-files.sh"
STAND_IN = """#!/bin/bash
# A stand-in of Python with pip, and of the script for single packages: it notes each call
for word in "$(basename "$0")" "$@"; do echo "${{word}}"; done >>{folder}/calls
exit {status}
"""


@pytest.mark.parametrize("status", [0, 1])
def test_a_file_is_installed_whole_or_line_by_line(tmp_path: Path, status: int) -> None:
    for name, code in (("python3", status), ("install-optional-pip", 0)):
        (tmp_path / name).write_text(STAND_IN.format(folder=tmp_path, status=code))
        (tmp_path / name).chmod(0o755)
    file = tmp_path / "requirements.txt"
    file.write_text("# for the demo\n--extra-index-url https://example.org\ntorch>=2  # any\n\n  gradio\n")
    found = subprocess.run(
        ["bash", str(SCRIPT), "python3", "--no-cache-dir", "--", str(tmp_path / "absent.txt"), str(file)],
        env={**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}"},
        capture_output=True,
        text=True,
        check=True,
    )
    assert "absent.txt was not cloned" in found.stderr
    whole = ["python3", "-m", "pip", "install", "--no-cache-dir", "--requirement", str(file)]
    single = ["install-optional-pip", "python3", "--no-cache-dir", "--", "torch>=2", "gradio"]
    assert (tmp_path / "calls").read_text().splitlines() == whole + (single if status else [])
