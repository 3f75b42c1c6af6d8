"""No value can become a command, an output of another name, or markup."""

from __future__ import annotations

from pathlib import Path

import pytest

from hostile_tree import commands
from roslab.errors import ConfigurationError, Problem
from roslab.github import workflow
from roslab.values.origin import Place


def test_an_error_at_its_place() -> None:
    error = ConfigurationError(
        Problem(message="100% wrong", hint="write x", origin=Place(file="a,b:c.yaml", line=3, column=5)), "second"
    )
    assert workflow.error_commands(error) == (
        "::error file=a%2Cb%3Ac.yaml,line=3,col=5::100%25 wrong (write x)\n::error::second\n"
    )


def test_a_line_break_begins_no_command() -> None:
    assert "\n" not in workflow.command("warning", "a\r\n::set-output name=x::y", {"file": "a\n::b"})


@pytest.mark.parametrize(
    "said",
    ["a\n::error::x", "a\r::error::x", "  ::error::x", "::set-output name=a::b", "b ##[add-mask]x", "##[error]x"],
)
def test_a_line_of_progress_is_no_command(capfd: pytest.CaptureFixture[str], said: str) -> None:
    workflow.say(said)
    printed = capfd.readouterr().err
    assert printed.count("\n") == 1
    assert len(printed.splitlines()) == 1
    assert commands(printed) == []
    assert commands(said) != []


def test_an_output_cannot_end_itself(tmp_path: Path) -> None:
    file = tmp_path / "output"
    hostile = "first\nend-0\nEOF\nname=value\nother<<EOF"
    workflow.outputs({"a": hostile, "b": ""}, {"GITHUB_OUTPUT": str(file)})
    lines = file.read_text().splitlines()
    name, delimiter = lines[0].split("<<")
    assert name == "a"
    assert lines.index(delimiter) == len(hostile.splitlines()) + 1
    assert "\n".join(lines[1 : lines.index(delimiter)]) == hostile


def test_a_group_switches_commands_off(capfd: pytest.CaptureFixture[str]) -> None:
    with workflow.group("title\n::error::x"):
        print("::error::from inside")
    lines = capfd.readouterr().err.splitlines()
    assert lines[0] == "::group::title%0A::error::x"
    token = lines[1].removeprefix("::stop-commands::")
    assert len(token) == 32
    assert lines[-2:] == [f"::{token}::", "::endgroup::"]


def test_a_long_summary_is_cut(tmp_path: Path) -> None:
    file = tmp_path / "summary"
    workflow.summary("ä" * 50 + "\n" + ("x" * 99 + "\n") * 20_000, {"GITHUB_STEP_SUMMARY": str(file)})
    assert file.stat().st_size <= workflow.SUMMARY_LIMIT
    assert file.read_text().endswith("longer than a summary may be._\n")
