"""The Python of this repository: ruff, mypy and the rooms' imports, as pyproject.toml sets them."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest


@pytest.mark.parametrize(
    "command",
    [("ruff", "check", "."), ("ruff", "format", "--check", "."), ("mypy",)],
    ids=" ".join,
)
def test_no_complaint(command: tuple[str, ...], checkout: Path) -> None:
    answer = subprocess.run(
        [sys.executable, "-m", *command], cwd=checkout, capture_output=True, text=True, check=False, timeout=600
    )
    assert answer.returncode == 0, answer.stdout + answer.stderr


def imports(program: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Hold the imports of the program in a folder against the contracts of the pyproject.toml beside it."""
    return subprocess.run(
        [program, "--no-cache", "--config", "pyproject.toml"],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(folder / "scripts")},
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )


def test_rooms_import_only_what_is_below_them(tool: Callable[[str], str], checkout: Path) -> None:
    answer = imports(tool("lint-imports"), checkout)
    assert answer.returncode == 0, answer.stdout + answer.stderr


@pytest.mark.parametrize(
    ("module", "imported", "contract"),
    [
        ("evidence/places.py", "decide.kind", "Data goes one way"),
        ("knowledge/table.py", "errors", "Knowledge is a leaf"),
        ("evidence/lex/yaml.py", "evidence.ros.vcs", "Readers stand on lexers"),
        ("evidence/gather.py", "repository.git", "Evidence runs no program"),
    ],
)
def test_an_import_that_goes_up_is_told(  # noqa: PLR0917 - fixtures
    module: str, imported: str, contract: str, tool: Callable[[str], str], checkout: Path, tmp_path: Path
) -> None:
    program = tool("lint-imports")
    shutil.copytree(checkout / "scripts", tmp_path / "scripts", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(checkout / "pyproject.toml", tmp_path)
    path = tmp_path / "scripts" / "roslab" / module
    path.write_text(path.read_text(encoding="utf-8") + f"\nimport roslab.{imported}\n", encoding="utf-8")
    answer = imports(program, tmp_path)
    assert answer.returncode == 1, answer.stdout + answer.stderr
    assert any(contract in told and "BROKEN" in told for told in answer.stdout.splitlines()), answer.stdout
