"""A pinned release that does not build here, and has a wheel for another Python."""

from __future__ import annotations

import io
import os
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest

from roslab.cli.repairing import given
from roslab.errors import BuildError, Problem
from roslab.explain.answer import explain
from roslab.pipeline import plan_repository
from roslab.render import dockerfile
from roslab.repair.change import Repair
from roslab.repair.other_python import completed
from trees import tree_of

SCRIPT = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts/wheels-of.sh"
BUILT = (
    "Downloading fast_robot-2.0.tar.gz (10 kB)",
    "  Building wheel for fast-robot (pyproject.toml): finished with status 'error'",
    "  ERROR: Failed building wheel for fast-robot",
    "Failed to build fast-robot",
    "\u00d7 Failed to build installable wheels for some pyproject.toml based projects",
)
METADATA = ("Downloading fast-robot-2.0.tar.gz", "ERROR: Failed to build 'fast-robot' when getting requirements")
OF_TWO_LINES = (
    "Using cached fast-robot-2.0.tar.gz",
    "error: metadata-generation-failed",
    "\u00d7 Encountered error while generating package metadata.",
    "\u2570\u2500> fast-robot",
)
FILES = {"requirements.txt": "six\nfast.robot==2.0\n", "main.py": "import fast_robot\n"}
PYTHON = {"roslab.yaml": "format: 3\nkind: python\n"}


def repaired(folder: Path, files: dict[str, str], lines: Sequence[str], answer: str) -> tuple[Repair, list[str]]:
    asked: list[str] = []

    def ask(sent: Sequence[str]) -> str:
        asked.extend(sent)
        if not answer:
            raise BuildError(Problem(message="no engine"))
        return answer

    said = "".join(f"#6 1.2 {line}\n" for line in lines)
    log = f'#6 [3/4] RUN pip install -r a.txt\n{said}#6 ERROR: process "/bin/sh -c pip install -r a.txt" did not: 1\n'
    tree_of(folder, {**FILES, **PYTHON, **files})
    return completed(Repair(), explain(io.BytesIO(log.encode())), given(plan_repository(folder)), ask), asked


@pytest.mark.parametrize("lines", [BUILT, METADATA, OF_TWO_LINES])
def test_the_newest_python_with_a_wheel_is_taken(tmp_path: Path, lines: tuple[str, ...]) -> None:
    found, asked = repaired(tmp_path, {}, lines, "fast-robot 3.8\nfast-robot 3.9\nother 3.7\nfast-robot 2.9\n")
    (change,) = found.changes
    assert str(change) == "base.python: 3.9"
    assert str(change.asked) == "the wheel of fast.robot==2.0 (requirements.txt:2)"
    assert change.certain
    (line,) = asked
    assert line.startswith("fast-robot 2.0 3.10 3.8 3.12 ")
    assert " 2.7" not in line


@pytest.mark.parametrize(
    ("files", "answer", "why"),
    [
        ({}, "fast-robot 3.10\nfast-robot 3.9\n", ""),  # the image's own: it fails for another reason
        ({}, "nothing\n", "pip's index has no wheel of fast.robot==2.0 for any Python that fits"),
        ({}, "", "pip's index was not asked for wheels: no engine"),
    ],
)
def test_where_there_is_none_that_is_said(tmp_path: Path, files: dict[str, str], answer: str, why: str) -> None:
    found, _ = repaired(tmp_path, files, BUILT, answer)
    assert found.changes == ()
    assert [reason for _, reason in found.refused] == ([why] if why else [])


def test_a_project_s_own_limit_holds(tmp_path: Path) -> None:
    project = '[project]\nname = "arm"\nversion = "1"\nrequires-python = ">=3.9"\n'
    _, asked = repaired(tmp_path, {"pyproject.toml": project}, BUILT, "fast-robot 3.9\n")
    assert not {"3.6", "3.7", "3.8"} & {*asked[0].split()}


@pytest.mark.parametrize(
    ("files", "lines"),
    [
        ({"requirements.txt": "six\nfast-robot>=2\n"}, BUILT),  # pip may take another release
        ({"requirements.txt": "six\n"}, BUILT),
        ({}, BUILT[1:]),
        ({"requirements.txt": "--index-url https://packages.example/simple\nfast-robot==2.0\n"}, BUILT),
        ({}, (*BUILT, "OSError: [Errno 28] No space left on device")),
        ({"roslab.yaml": "format: 3\nkind: python\nbase: {image: 'example/robot:1'}\n"}, BUILT),
        (
            {
                "roslab.yaml": "format: 3\nbase: {ros: noetic}\n",
                "package.xml": "<package><name>arm</name><version>1.0.0</version>"
                "<buildtool_depend>catkin</buildtool_depend></package>",
                "CMakeLists.txt": "project(arm)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
            },
            BUILT,
        ),
    ],
)
def test_nobody_is_asked_where_it_cannot_help(tmp_path: Path, files: dict[str, str], lines: tuple[str, ...]) -> None:
    found, asked = repaired(tmp_path, files, lines, "fast-robot 3.9\n")
    assert (found, asked) == (Repair(), [])


def test_a_release_is_asked_for_as_the_index_spells_it(tmp_path: Path) -> None:
    lines = [line.replace("2.0", "2.0.0") for line in BUILT]
    found, asked = repaired(tmp_path, {}, lines, "fast-robot 3.9\n")
    assert asked[0].startswith("fast-robot 2.0.0 ")
    assert str(found.changes[0].asked) == "the wheel of fast.robot==2.0 (requirements.txt:2)"


def test_the_question_is_a_file_of_the_image_s_base(tmp_path: Path) -> None:
    tree_of(tmp_path, {**FILES, **PYTHON})
    text = dockerfile.wheels(plan_repository(tmp_path).plan, ["fast-robot 2.0 3.10 3.8"])
    assert "\nfast-robot 2.0 3.10 3.8\n" in text
    assert "wheels-of /asked >/answer" in text
    assert text.endswith("FROM scratch\nCOPY --from=base /answer /\n")


PIP = """\
#!/bin/bash
case "$*" in
  *"versions fast-robot --python-version 3.8 "*) echo 'fast-robot (3.0)' && echo 'Available versions: 3.0, 2.0, 1.0' ;;
  *"versions fast-robot --python-version 3.9 "*) echo 'fast-robot (3.0)' && echo 'Available versions: 3.0, 2.0.1' ;;
  *) exit 1 ;;
esac
"""


def test_the_script_names_the_pythons_whose_wheels_pip_lists(tmp_path: Path) -> None:
    (tmp_path / "python3").write_text(PIP)
    (tmp_path / "python3").chmod(0o755)
    (tmp_path / "asked").write_text("fast-robot 2.0 3.10 3.8 3.9\nother 1.0 3.8\n")
    names = {**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}"}
    command = ["bash", str(SCRIPT), str(tmp_path / "asked")]
    answer = subprocess.run(command, env=names, capture_output=True, text=True, check=True)
    assert answer.stdout == "fast-robot 3.8\n"
