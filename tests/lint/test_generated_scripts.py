"""shellcheck on every shell script that is generated, those inside the Dockerfiles too."""

from __future__ import annotations

import os
import re
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from golden_files import EXAMPLES, names, whole

CARRIED = Path(__file__).resolve().parents[2] / "scripts" / "roslab" / "render" / "image_scripts"
SCRIPTS = [(name, path) for name in names() for path in whole(name) if path.endswith(".sh")]
HEREDOC = re.compile(r"^COPY .*<<'EOF' .*?(\.\w+)?\n((?:.*\n)*?)EOF$", re.MULTILINE)
"""A file that a Dockerfile carries: the ending of its name, and its text."""


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


@pytest.mark.parametrize(("name", "path"), SCRIPTS)
def test_script(name: str, path: str, tool: Callable[[str], str]) -> None:
    text = whole(name)[path]
    assert text.startswith("#!/usr/bin/env bash\n")
    assert "set -euo pipefail" in text
    shellcheck(text, tool("shellcheck"))


@pytest.mark.parametrize("name", names())
def test_files_inside_a_dockerfile(name: str, tool: Callable[[str], str]) -> None:
    for ending, text in HEREDOC.findall(whole(name).get("Dockerfile", "")):
        if ending not in {".asc", ".txt"}:  # keys and tables
            shellcheck(text, tool("shellcheck"))


@pytest.mark.parametrize("file", sorted(CARRIED.glob("*.sh")), ids=lambda path: path.stem)
def test_script_that_dockerfiles_carry(file: Path, tool: Callable[[str], str]) -> None:
    text = file.read_text()
    assert re.match(r"#!/bin/bash\n# [A-Zu]", text), "it begins with what it does"
    assert "\nset -e" in text
    assert "\nEOF\n" not in text, "the heredoc that carries it would end there"
    shellcheck(text, tool("shellcheck"))


@pytest.mark.parametrize("name", names())
def test_what_verifies_an_example(name: str, tool: Callable[[str], str]) -> None:
    verify = EXAMPLES / name / "verify"
    assert os.access(verify, os.X_OK)
    assert verify.read_text().startswith("#!/bin/bash\n# Runs inside the image")
    assert "\nset -euo pipefail\n" in verify.read_text()
    shellcheck(verify.read_text(), tool("shellcheck"))


def test_there_are_scripts_of_every_example() -> None:
    assert {name for name, _ in SCRIPTS} == {*names()}


@pytest.mark.parametrize("name", ["inventory.sh", "online.sh"])
def test_what_reads_an_image_is_clean(name: str, tool: Callable[[str], str]) -> None:
    shellcheck((CARRIED.parents[1] / "lock" / name).read_text(), tool("shellcheck"))
