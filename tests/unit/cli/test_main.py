"""What a bug of ours prints: one line that neither a terminal nor a runner takes for anything else."""

from __future__ import annotations

import argparse

import pytest

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
