"""The release of a builder that is installed is compared number by number with the first that is too new."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from roslab.knowledge.build_limits import build_limits
from roslab.render import image_scripts


@pytest.mark.parametrize(
    ("version", "below", "newer"),
    [
        ("0.42.0", "0.40", True),
        ("0.40.0", "0.40", True),
        ("0.38.4", "0.40", False),
        ("0.9", "0.40", False),
        ("67.8.0", "67", True),
        ("67", "67", True),
        ("66.1.1", "67", False),
        ("3.0.0a11", "3", True),
        ("", "67", False),
    ],
)
def test_it_is_newer(tmp_path: Path, version: str, below: str, newer: bool) -> None:
    python = tmp_path / "python3"
    python.write_text(f"#!/bin/bash\nif [ \"$1\" = -c ]; then exit 1; fi\necho 'Name: x'\necho 'Version: {version}'\n")
    python.chmod(0o755)
    script = Path(image_scripts.__path__[0]) / "ask-pip-again.sh"
    asked = f"source {script}; package=x below={below} python=4.0; roslab_newer_beside {python} && echo newer || true"
    found = subprocess.run(["bash", "-c", asked], check=True, capture_output=True, text=True)
    assert (found.stdout.strip() == "newer") is newer


LOG = (
    "  wheel.vendored.packaging.requirements.InvalidRequirement: Expected end or semicolon (after version specifier)\n"
)
NEWER = (
    "  packaging.requirements.InvalidRequirement: Expected comma (within version specifier), semicolon (after version "
    "specifier) or end\n"
)


@pytest.mark.parametrize(
    ("said", "suits"),
    [
        (LOG, False),
        (LOG.replace("wheel.vendored.", ""), False),
        (LOG.replace("wheel.vendored", "pip._vendor"), True),
        (NEWER, False),
    ],
)
def test_a_requirement_that_newer_wheels_refuse_is_known_by_its_message(tmp_path: Path, said: str, suits: bool) -> None:
    (tmp_path / "log").write_text(said)
    patterns = [line.split(" ", 3) for line in build_limits().splitlines()]
    (pattern,) = [rest for package, _, _, rest in patterns if package == "wheel"]
    found = subprocess.run(["grep", "-q", "-E", pattern, tmp_path / "log"], check=False)
    assert (found.returncode != 0) is suits


@pytest.mark.parametrize(
    ("said", "suits"),
    [
        ("a.c:3:5: error: `PyArray_Descr` {aka `struct _PyArray_Descr`} has no member named `f`\n", False),
        ("a.c:1:10: fatal error: numpy/noprefix.h: No such file or directory\n", False),
        ("a.c:3:5: error: `PyArrayObject` has no member named `f`\n", True),
    ],
)
def test_what_numpy_2_no_longer_has_is_known_by_the_compiler_s_message(tmp_path: Path, said: str, suits: bool) -> None:
    (tmp_path / "log").write_text(said)
    (pattern,) = [line.split(" ", 3)[3] for line in build_limits().splitlines() if line.startswith("numpy ")]
    found = subprocess.run(["grep", "-q", "-E", pattern, tmp_path / "log"], check=False)
    assert (found.returncode != 0) is suits
