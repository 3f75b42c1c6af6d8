"""What ``inspect`` prints for a person."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.decide.decision import Reason
from roslab.pipeline import plan_repository
from roslab.render.report import explanation, inspection_text

EXAMPLES = sorted(path.name for path in (Path(__file__).parents[3] / "examples").iterdir() if path.is_dir())


def printed(examples: Path, name: str) -> str:
    planned = plan_repository(examples / name, folder_name=name)
    return inspection_text(planned.decision, planned.plan)


@pytest.mark.parametrize("name", EXAMPLES)
def test_reasons_stand_in_one_column(examples: Path, name: str) -> None:
    rows = printed(examples, name).split("\n\n")[1].splitlines()
    explained = [row for row in rows if "  " in row[14:]]
    columns = {len(row) - len(row[14:].partition("  ")[2].lstrip()) for row in explained}
    assert len(explained) >= 3
    assert len(columns) == 1, rows


@pytest.mark.parametrize("name", EXAMPLES)
def test_other_commands_are_others(examples: Path, name: str) -> None:
    text = printed(examples, name)
    (command,) = (line[14:].split("  ")[0] for line in text.splitlines() if line.startswith("  command "))
    others = text.partition("other commands:\n")[2].partition("\n\n")[0].splitlines()
    assert f"  {command}" not in others


def test_nothing_is_said_to_be_installed_beside_an_authors_dockerfile(examples: Path) -> None:
    text = printed(examples, "own_dockerfile")
    assert "guessed" not in text
    assert "where this base knows them" not in text
    assert (
        "named by the Dockerfile and the code; what is installed, the Dockerfile says (3):\n  python3 python3-numpy"
        in text
    )
    assert "python3 pose_chain.py     the author's Dockerfile starts it (docker/Dockerfile:11)" in text


def test_what_may_be_in_a_repository_is_told_apart_from_what_is_cloned(tmp_path: Path) -> None:
    package = "<package><name>nav</name><buildtool_depend>catkin</buildtool_depend><depend>nav_lib</depend></package>"
    (tmp_path / "package.xml").write_text(package)
    (tmp_path / "CMakeLists.txt").write_text("project(nav)\nfind_package(catkin REQUIRED)\ncatkin_package()\n")
    (tmp_path / "README.md").write_text("ROS Noetic.\n")
    (tmp_path / ".git").mkdir()
    (tmp_path / ".git/config").write_text('[remote "origin"]\n\turl = https://github.com/lab/nav.git\n')
    planned = plan_repository(tmp_path)
    text = inspection_text(planned.decision, planned.plan)
    assert "looked for while the image is built:\n  nav_lib in https://github.com/lab/nav_lib.git\n" in text
    assert "from source:" not in text


@pytest.mark.parametrize(
    ("image", "shown"),
    [
        ("python:3.10-slim", False),
        ("python:3.9", False),
        ("debian:12", False),
        ("node:20", False),
        ("ubuntu:22.04", True),
        ("lab/arm:1", True),
    ],
)
def test_no_ubuntu_is_told_of_an_image_of_debian(tmp_path: Path, image: str, *, shown: bool) -> None:
    files = {
        "Dockerfile": f'FROM {image}\nCOPY . /app\nRUN pip install /app\nCMD ["python", "/app/run.py"]\n',
        "run.py": "import numpy\nif __name__ == '__main__':\n    print(1)\n",
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    planned = plan_repository(tmp_path)
    assert planned.decision.dockerfile
    assert ("\n  Ubuntu " in inspection_text(planned.decision, planned.plan)) is shown


def test_what_speaks_for_the_answer_is_not_shown_as_against_it() -> None:
    reasons = (
        Reason(question="command", answer="run a", reason="the page runs it, before 1 other", file="README.md", line=3),
        Reason(question="command", answer="run a", reason="the page runs it", file="README.md", line=3, decisive=False),
        Reason(question="command", answer="run b", reason="a launch file", file="b.launch", line=1, decisive=False),
        Reason(question="command", answer="run a", reason="a launch file", file="a.launch", line=1, decisive=False),
        Reason(question="command", answer="run a", reason="it is a test", weight=-1, decisive=False),
    )
    assert explanation(reasons, "command").splitlines() == [
        "command:",
        "  + run a: the page runs it, before 1 other (README.md:3)",
        "  + run a: a launch file (a.launch:1)",
        "  - run b: a launch file (b.launch:1)",
        "  - run a: it is a test",
    ]


def test_a_dockerfile_that_is_not_built_is_not_shown_as_the_answer() -> None:
    reasons = (
        Reason(question="dockerfile", answer="ci/Dockerfile", reason="it is for CI", file="ci/Dockerfile", weight=-1),
        Reason(question="dockerfile", answer="Dockerfile", reason="the author's", file="Dockerfile", weight=500),
    )
    assert explanation(reasons, "dockerfile").splitlines()[1:] == [
        "  + Dockerfile: the author's (Dockerfile)",
        "  - ci/Dockerfile: it is for CI (ci/Dockerfile)",
    ]
