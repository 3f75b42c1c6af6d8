"""What an input or an option says is explained by its name, never by a line of roslab.yaml that says otherwise."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from roslab.cli.main import main
from roslab.config import Override
from roslab.pipeline import plan_repository
from roslab.values.origin import Input

FILE = (
    "format: 3\nplatforms: [linux/amd64, linux/arm64]\nbase:\n  python: '3.9'\ncommand: python3 a.py\ntest: 'false'\n"
)


@pytest.fixture
def robot(examples: Path, tmp_path: Path) -> Path:
    shutil.copytree(examples / "python_filter", tmp_path / "robot")
    (tmp_path / "robot" / "roslab.yaml").write_text(FILE)
    return tmp_path / "robot"


@pytest.mark.parametrize(
    ("question", "option", "value"),
    [("platforms", "--platform", "linux/amd64"), ("command", "--command", "bash"), ("test", "--test", "true")],
)
def test_an_option(robot: Path, capsys: pytest.CaptureFixture[str], question: str, option: str, value: str) -> None:
    assert main(["inspect", str(robot), "--explain", question, option, value]) == 0
    assert f"  + {value}: {option} says so\n" in capsys.readouterr().out
    assert main(["inspect", str(robot), "--format", "json", option, value]) == 0
    evidence = json.loads(capsys.readouterr().out)["evidence"]
    assert [entry for entry in evidence if entry["question"] == question] == [
        {"question": question, "answer": value, "file": None, "line": None, "reason": f"{option} says so"}
    ]


@pytest.mark.parametrize(
    ("question", "key", "name", "value"),
    [
        ("python", "base.python", "python", "3.8"),
        ("kind", "kind", "kind", "cpp"),
        ("cuda", "base.cuda", "cuda", "11.8"),
        ("ros_distro", "base.ros", "distro", "humble"),
        ("build_tool", "build", "build-tool", "cmake"),
        ("platforms", "platforms", "platforms", "linux/arm64"),
        ("test", "test", "test", "true"),
    ],
)
def test_an_input(robot: Path, question: str, key: str, name: str, value: str) -> None:
    override = Override(key=key, text=value, origin=Input(name=name))
    reasons = plan_repository(robot, overrides=(override,)).plan.reasons
    best = next(reason for reason in reasons if reason.question == question and reason.decisive)
    assert (best.answer, best.reason, best.file, best.line) == (value, f"input {name} says so", None, None)


def test_the_file(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for question, answer, line in (
        ("test", "false", 6),
        ("command", "python3 a.py", 5),
        ("platforms", "linux/arm64", 2),
    ):
        main(["inspect", str(robot), "--explain", question])
        first = capsys.readouterr().out.splitlines()[1]
        assert answer in first
        assert first.endswith(f"{question} says so (roslab.yaml:{line})")
