"""Every example gives exactly these files. ``REPRO_REFRESH=1 pytest tests/golden`` rewrites them: read the diff."""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from golden_files import CASES_GOLDEN, CONSTANT, DISTROS, EXAMPLES, GOLDEN, MARK, contents, names, refresh, whole

NAMES = names()


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

    if os.environ.get("REPRO_REFRESH") == "1":
        refresh(name, made)
    wanted = whole(name)
    assert sorted(made) == sorted(wanted)
    for path, text in made.items():
        assert text == wanted[path], f"{name}/{path} changed: if that is right, REPRO_REFRESH=1 and read the diff"


def test_no_golden_files_without_their_example() -> None:
    folders = {path.name for path in GOLDEN.iterdir() if path.is_dir()} - {
        "__pycache__",
        CONSTANT,
        DISTROS,
        CASES_GOLDEN.name,
    }
    assert sorted(folders) == NAMES


def test_no_constant_part_that_no_example_has() -> None:
    marked = {
        mark
        for name in (*NAMES, DISTROS, CASES_GOLDEN.name)
        for text in contents(GOLDEN / name).values()
        for mark in MARK.findall(text)
    }
    assert sorted(contents(GOLDEN / CONSTANT)) == sorted(marked)


def test_a_changed_constant_part_is_seen(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """The marks hide nothing: a byte more in a constant part is a byte more in every file that has it."""
    before = {name: whole(name) for name in NAMES}
    shutil.copytree(GOLDEN, tmp_path / "golden")
    monkeypatch.setattr("golden_files.GOLDEN", tmp_path / "golden")
    for part in (tmp_path / "golden" / CONSTANT).iterdir():
        part.write_text(part.read_text() + "# more\n")
    for name in NAMES:
        changed = {path for path, text in whole(name).items() if text != before[name][path]}
        assert changed == {"Dockerfile", "docker_build.sh", "docker_run.sh"} & before[name].keys()


def test_what_belongs_to_the_ros_1_example_fits_on_a_screen() -> None:
    """Every instruction; what the file carries as heredocs and the comments beside the instructions are not counted."""
    text = whole("ros1_talker")["Dockerfile"]
    own = re.sub(r"^COPY [^\n]*<<'EOF' .*?^EOF\n\n?", "", text, flags=re.MULTILINE | re.DOTALL)
    assert "roslaunch ros1_talker" in own
    assert "rosdep update" not in own
    lines = [line for line in own.splitlines() if line and not line.startswith("#")]
    assert len(lines) <= 47, own


@pytest.mark.parametrize("name", NAMES)
def test_what_verifies_an_example_is_no_evidence(
    roslab: Callable[..., CompletedProcess[str]], name: str, tmp_path: Path
) -> None:
    """The file `verify` belongs to the tests: an example shows what is read from a repository that has none."""
    copy = tmp_path / name
    shutil.copytree(EXAMPLES / name, copy, ignore=shutil.ignore_patterns("__pycache__", "verify"))
    assert roslab("plan", copy).stdout == whole(name)["plan.json"]


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
