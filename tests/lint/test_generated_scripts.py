"""shellcheck on every shell script that is generated, those inside the Dockerfiles too."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
SCRIPTS = sorted(ROOT.glob("tests/golden/*/*.sh"))
DOCKERFILES = sorted(ROOT.glob("tests/golden/*/Dockerfile"))


def shellcheck(text: str, program: str) -> None:
    answer = subprocess.run(
        # SC1090, SC1091: the ROS setup scripts are in the image only
        [program, "--shell=bash", "--exclude=SC1090,SC1091", "-"],
        input=text,
        capture_output=True,
        text=True,
        check=False,
    )
    assert answer.returncode == 0, answer.stdout + answer.stderr


@pytest.mark.parametrize("file", SCRIPTS, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_script(file: Path, tool: Callable[[str], str]) -> None:
    text = file.read_text()
    assert text.startswith("#!/usr/bin/env bash\n")
    assert "set -euo pipefail" in text
    shellcheck(text, tool("shellcheck"))


@pytest.mark.parametrize("file", DOCKERFILES, ids=lambda path: path.parent.name)
def test_files_inside_a_dockerfile(file: Path, tool: Callable[[str], str]) -> None:
    for text in re.findall(r"^COPY .*<<'ROSLAB' .*\n((?:.*\n)*?)ROSLAB$", file.read_text(), re.MULTILINE):
        shellcheck(text, tool("shellcheck"))


def test_there_are_scripts_of_every_example() -> None:
    examples = sorted(path.name for path in (ROOT / "examples").iterdir() if path.is_dir())
    assert sorted({path.parent.name for path in SCRIPTS}) == examples
