"""What is taken out of a conda file before it is read: by the command of the Dockerfile, which runs here."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.layers.conda_lines import changed
from roslab.values.dataclass import replace

PLAIN = "name: a\ndependencies:\n- python=3.10\n- numpy\n"
FILE = "dependencies:\n- pytorch\n- pip\n- pip:\n  - numpy\n{}\n"


def without(folder: Path, text: str, *entries: str, others: bool = True) -> str:
    """Return the text of a conda file after the commands that take these entries out of it."""
    (folder / "environment.yml").write_text(PLAIN)
    plan = replace(plan_repository(folder).plan.python, conda_local=entries, conda_pip=others)
    file = folder / "changed.yml"
    file.write_bytes(text.encode())
    for command in changed(plan, str(file)):
        subprocess.run(["bash", "-c", command], check=True)
    return file.read_bytes().decode()


@pytest.mark.parametrize("end", ["\n", "\r\n"])
@pytest.mark.parametrize(
    "line",
    [
        "  - sklearn",
        "  - sklearn  # metrics",
        "  - sklearn == 0.0",
        "  - \"sklearn; python_version >= '3.4'\"",
        "  - sklearn[extra]>=0.0",
        "  - pytorch",
        "  - -e ./own",
        "  - -e ./own[sim]",
    ],
)
def test_lines_for_pip_are_taken_out(tmp_path: Path, line: str, end: str) -> None:
    text = FILE.format(line).replace("\n", end)
    assert without(tmp_path, text, "own", "sklearn", "pytorch").split() == FILE.format("").split()


def test_nothing_of_another_name_is_taken_out(tmp_path: Path) -> None:
    text = FILE.format("  - sklearn-extra\n  - owner\n  - scikit-sklearn==1.0")
    assert without(tmp_path, text, "own", "sklearn") == text


def test_where_nothing_is_left_for_pip_its_line_goes(tmp_path: Path) -> None:
    text = "dependencies:\n- numpy\n- pip:\n  - -e .\n"
    assert without(tmp_path, text, ".", others=False) == "dependencies:\n- numpy\n"
