"""A guessed package stays where something that it asks for cannot be had; the script runs against a stand-in of pip."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts

SCRIPT = Path(image_scripts.__path__[0]) / "install-optional-pip.sh"
STAND_IN = """#!/bin/bash
# A stand-in of Python with pip, which cannot install the package with what it asks for, nor an old matplotlib
case "$*" in
  "-c "*) echo {folder}/site-packages ;;
  "- "*) printf 'numpy\\nmatplotlib<3\\n' ;;
  "-m pip list"*) cat {folder}/installed ;;
  *)
    echo "$*" | sed 's|--constraint [^ ]*|--constraint KEPT|; s/^-m pip install //' >>{folder}/calls
    case "$*" in
      *--no-deps*) echo 'toppra==0.2' >>{folder}/installed ;;
      *toppra*) cp {folder}/said "${{PIP_LOG}}" && exit 1 ;;
      *'matplotlib<3'*) exit 1 ;;
    esac ;;
esac
"""
PACKAGE = "toppra @ git+https://github.com/lab/toppra@8df858b"
COLLECTED = "2026-11-28T17:00:00,000 Collecting toppra@ git+https://github.com/lab/toppra\n"
NEEDED = "2026-11-28T17:00:00,000 Collecting matplotlib<3 (from toppra)\n"
TRIES = [PACKAGE, f"--no-build-isolation {PACKAGE}"]
APART = [f"--no-deps {PACKAGE}", "--constraint KEPT numpy", "--constraint KEPT matplotlib<3"]


EXTRAS = "toppra[plots] @ git+https://github.com/lab/toppra@8df858b"


@pytest.mark.parametrize("package", [PACKAGE, EXTRAS])
@pytest.mark.parametrize(
    ("said", "apart"),
    [
        (f"{COLLECTED}{NEEDED}ERROR: metadata generation failed\n", True),
        (f"{COLLECTED}{NEEDED}  ERROR: Failed building wheel for matplotlib\n", True),
        (f"{COLLECTED}{NEEDED}  ERROR: Failed building wheel for toppra\n", False),
        (f"{COLLECTED}ERROR: metadata generation failed\n", False),
    ],
)
def test_it_is_installed_alone(tmp_path: Path, said: str, package: str, *, apart: bool) -> None:
    (tmp_path / "said").write_text(said)
    (tmp_path / "installed").write_text("numpy==1.24.4\n")
    (tmp_path / "python3").write_text(STAND_IN.format(folder=tmp_path))
    again = (SCRIPT.parent / "ask-pip-again.sh").read_text().replace("/dev/shm", str(tmp_path))
    (tmp_path / "ask-pip-again").write_text(again.replace("/usr/local/share/roslab", str(tmp_path)))
    for name in ("python3", "ask-pip-again"):
        (tmp_path / name).chmod(0o755)
    script = SCRIPT.read_text().replace("/usr/local/share/roslab/left-out.txt", f"{tmp_path}/left-out.txt")
    subprocess.run(
        ["bash", "-c", script, "install-optional-pip", f"{tmp_path}/python3", "--", package],
        env={**os.environ, "TMPDIR": str(tmp_path), "PATH": f"{tmp_path}:{os.environ['PATH']}"},
        capture_output=True,
        check=True,
    )
    calls = [line.replace(package, PACKAGE) for line in (tmp_path / "calls").read_text().splitlines()]
    assert calls == [*TRIES, *(APART if apart else [])]
    left_out = "pip matplotlib<3" if apart else f"pip {package}"
    assert (tmp_path / "left-out.txt").read_text() == f"{left_out}\n"
