"""The command line reads what it is handed, and tells everything about itself."""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from pathlib import Path

import pytest

from roslab.cli.arguments import EXIT_CODES, ROUNDS, completed, parser
from roslab.cli.main import main


def commands(top: argparse.ArgumentParser) -> dict[str, argparse.ArgumentParser]:
    action = next(action for action in top._actions if isinstance(action, argparse._SubParsersAction))
    return dict(action.choices)


def test_the_arguments_it_is_handed_count(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["something", "else"])
    with pytest.raises(SystemExit) as stopped:
        main(["github", "--help"])
    assert stopped.value.code == 0
    assert "Steps of a workflow" in capsys.readouterr().out


def test_those_of_the_process_do_not(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["roslab", "github"])
    with pytest.raises(SystemExit):
        main(["--help"])
    said = capsys.readouterr().out
    assert "steps of a workflow" not in said
    assert "None" not in said


def test_a_laptop_loads_nothing_of_github() -> None:
    code = "import sys; from roslab.cli.main import main\ntry: main(['--help'])\nexcept SystemExit: pass\n"
    code += "sys.exit(any(name.startswith('roslab.github') for name in sys.modules))"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, check=False).returncode == 0


@pytest.mark.parametrize("name", commands(parser()))
def test_every_command_says_what_it_does(name: str) -> None:
    command = commands(parser())[name]
    assert command.description
    assert EXIT_CODES in command.format_help()
    assert [action.dest for action in command._actions if not action.help] == []


@pytest.mark.parametrize(
    ("words", "path", "rounds"),
    [
        (["--repair", "3", "robot"], "robot", 3),
        (["--repair=3", "robot"], "robot", 3),
        (["robot", "--repair", "3"], "robot", 3),
        (["--repair", "3"], ".", 3),
        (["--repair", "robot"], "robot", ROUNDS),
        (["robot", "--repair"], "robot", ROUNDS),
        (["--repair", "--slim", "robot"], "robot", ROUNDS),
    ],
)
def test_the_number_of_repairs_may_stand_as_the_help_shows_it(words: list[str], path: str, rounds: int) -> None:
    options = parser("build").parse_args(completed(["build", *words]))
    assert (options.path, options.repair) == (path, rounds)


@pytest.mark.parametrize("number", ["-3", "0", "21"])
def test_a_wrong_number_of_repairs_is_named(number: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(["build", "--repair", number, "robot"])
    assert stopped.value.code == 2
    assert f"argument --repair: '{number}' is no number from 1 to 20" in capsys.readouterr().err


def test_without_an_argument_the_usage_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main([])
    assert stopped.value.code == 2
    assert "required: COMMAND" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "instead"),
    [
        (["inspect", ""], "give a folder, or leave it out for this one"),
        (["create", "--output", ""], "give a folder, or leave it out for this one"),
        (["explain", ""], "give the file of the log, or - for standard input"),
    ],
)
def test_an_empty_path_is_none(words: list[str], instead: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(words)
    assert stopped.value.code == 2
    assert f"it is empty: {instead}" in capsys.readouterr().err


def test_a_plan_may_be_asked_for_as_json(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "requirements.txt").write_text("numpy\n", encoding="utf-8")
    assert main(["plan", "--format", "json", str(tmp_path)]) == 0
    assert json.loads(capsys.readouterr().out)["kind"] == "python"
