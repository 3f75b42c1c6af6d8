"""What a bug of ours prints: one line that neither a terminal nor a runner takes for anything else."""

from __future__ import annotations

import argparse
import subprocess
import sys
from pathlib import Path

import pytest

from roslab import __main__
from roslab.cli import main


@pytest.mark.parametrize("said", ["x\n::set-output name=digest::y", "a ##[set-output name=digest;]y", "a\x1b[31m"])
def test_a_bug_is_one_line_and_no_command(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], said: str
) -> None:
    def broken(_: argparse.Namespace) -> int:
        raise RuntimeError(said)

    monkeypatch.delenv("ROSLAB_DEBUG", raising=False)
    monkeypatch.setattr(main, "_handler", lambda _: broken)
    assert main.main(["inspect"]) == 1
    first, _, rest = capsys.readouterr().err.partition("\n")
    assert first.startswith("roslab: a bug: RuntimeError: ")
    assert "##[" not in first
    assert "\x1b" not in first
    assert rest == "Please report it; ROSLAB_DEBUG=1 shows where it happened.\n"


SCRIPTS = Path(__file__).parents[3] / "scripts"


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    (tmp_path / "requirements.txt").write_text("numpy\n")
    return tmp_path


@pytest.mark.parametrize("command", ["plan", "inspect"])
def test_an_output_that_is_full_is_no_bug_of_ours(tree: Path, command: str) -> None:
    """A plan is written at once, what is shorter only at the end: both are told, neither is a success."""
    with Path("/dev/full").open("w") as full:
        answer = subprocess.run(
            [sys.executable, "-I", str(SCRIPTS), command, str(tree)],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
    assert answer.returncode == 5
    assert answer.stderr == "roslab: error: No space left on device: what was to be written is not complete\n"


@pytest.mark.parametrize("closed", [">&-", "2>&-", ">&- 2>&-"])
def test_a_stream_that_is_closed_is_nobodys(tree: Path, closed: str) -> None:
    line = f'exec "$0" -I "$1" plan "$2" {closed}'
    words = ["sh", "-c", line, sys.executable, str(SCRIPTS), str(tree)]
    answer = subprocess.run(words, capture_output=True, text=True, check=False)
    assert answer.returncode == 0
    assert answer.stderr == ""


@pytest.mark.parametrize(
    ("words", "path", "command"),
    [
        (["--", "ls", "-l"], ".", ["ls", "-l"]),
        (["robot", "--", "ls", "-l"], "robot", ["ls", "-l"]),
        (["--tag", "v1", "--", "ls", "--tag", "--"], ".", ["ls", "--tag", "--"]),
        (["robot"], "robot", []),
        (["robot", "--"], "robot", []),
    ],
)
def test_what_follows_two_dashes_is_the_command_to_run(
    monkeypatch: pytest.MonkeyPatch, words: list[str], path: str, command: list[str]
) -> None:
    seen: list[argparse.Namespace] = []

    def kept(options: argparse.Namespace) -> int:
        seen.append(options)
        return 0

    monkeypatch.setattr(main, "_handler", lambda _: kept)
    assert main.main(["run", *words]) == 0
    assert (seen[0].path, seen[0].arguments) == (path, command)


def test_an_interrupt_while_modules_are_imported_is_one(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted() -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("roslab.cli.main.run", interrupted)
    with pytest.raises(SystemExit) as stopped:
        __main__.run()
    assert stopped.value.code == 130
    assert capsys.readouterr().err == "\nroslab: interrupted\n"


def test_a_mistyped_option_of_roslab_itself_is_named(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main.main(["--versoin"])
    assert stopped.value.code == 2
    assert "unrecognized arguments: --versoin" in capsys.readouterr().err


def test_a_day_still_to_come_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "a.py").write_text("import os\n", encoding="utf-8")
    (tmp_path / "roslab.yaml").write_text("format: 3\ndate: 2098-01-01\n", encoding="utf-8")
    assert main.main(["plan", str(tmp_path)]) == 2
    assert "date: 2098-01-01 is still to come" in capsys.readouterr().err
    (tmp_path / "roslab.yaml").unlink()
    assert main.main(["plan", str(tmp_path), "--date", "2098-01-01"]) == 2
    assert "error: --date: 2098-01-01 is still to come" in capsys.readouterr().err
