"""Every example gives exactly these files. ``REPRO_REFRESH=1 pytest tests/golden`` rewrites them: read the diff."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from pathlib import Path
from subprocess import CompletedProcess

import pytest

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parent.parent / "examples"
NAMES = sorted(path.name for path in EXAMPLES.iterdir() if path.is_dir())


def contents(folder: Path) -> dict[str, str]:
    """Return the text of every file below a folder by its relative path."""
    return {str(path.relative_to(folder)): path.read_text() for path in sorted(folder.rglob("*")) if path.is_file()}


@pytest.mark.parametrize("name", NAMES)
def test_files(roslab: Callable[..., CompletedProcess[str]], name: str, tmp_path: Path) -> None:
    copy = tmp_path / name  # the folder's name is the image's
    shutil.copytree(EXAMPLES / name, copy, ignore=shutil.ignore_patterns("__pycache__"))
    before = contents(copy)
    plan = roslab("plan", copy)
    assert plan.returncode == 0, plan.stderr
    assert roslab("plan", copy).stdout == plan.stdout
    create = roslab("create", copy)
    assert create.returncode == 0, create.stderr
    after = contents(copy)
    assert {path: after.get(path) for path in before} == before, "a file of the author's was changed"
    made = {path: text for path, text in after.items() if path not in before} | {"plan.json": plan.stdout}
    assert str(tmp_path) not in "".join(made.values()), "a path of this machine"

    golden = HERE / name
    if os.environ.get("REPRO_REFRESH") == "1":
        shutil.rmtree(golden, ignore_errors=True)
        for path, text in made.items():
            (golden / path).parent.mkdir(parents=True, exist_ok=True)
            (golden / path).write_text(text)
    wanted = contents(golden)
    assert sorted(made) == sorted(wanted)
    for path, text in made.items():
        assert text == wanted[path], f"{name}/{path} changed: if that is right, REPRO_REFRESH=1 and read the diff"


def test_no_golden_files_without_their_example() -> None:
    folders = sorted(path.name for path in HERE.iterdir() if path.is_dir() and path.name != "__pycache__")
    assert folders == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_plan_again_after_create(roslab: Callable[..., CompletedProcess[str]], name: str, tmp_path: Path) -> None:
    """What `create` wrote is no evidence: the next plan is the same, and `--force` writes the same files again."""
    copy = tmp_path / name
    shutil.copytree(EXAMPLES / name, copy, ignore=shutil.ignore_patterns("__pycache__"))
    plan = roslab("plan", copy).stdout
    assert roslab("create", copy).returncode == 0
    first = contents(copy)
    assert roslab("plan", copy).stdout == plan
    again = roslab("create", copy, "--force")
    assert again.returncode == 0, again.stderr
    assert contents(copy) == first
