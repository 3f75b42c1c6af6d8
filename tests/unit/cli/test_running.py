"""``roslab run --list``: what the image may be started with."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.cli import main


def test_the_default_command_comes_first_and_nothing_is_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("PATH", "")  # no docker is asked for
    (tmp_path / "README.md").write_text("# demo\n## Usage\n    python train.py --name ab\n    python show.py\n")
    for name in ("train", "show"):
        (tmp_path / f"{name}.py").write_text('if __name__ == "__main__":\n    print(1)\n')
    assert main.main(["run", "--list", str(tmp_path)]) == 0
    first, second, *_ = capsys.readouterr().out.splitlines()
    assert first == "python train.py --name ab"
    assert second == "python show.py"
    (tmp_path / "roslab.yaml").write_text("format: 3\nkind: python\ncommand: python show.py | cat\n")
    assert main.main(["run", "--list", str(tmp_path)]) == 0
    assert capsys.readouterr().out.splitlines()[0] == "python show.py | cat"


def test_without_a_program_it_is_the_shell(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "requirements.txt").write_text("numpy\n")
    assert main.main(["run", "--list", str(tmp_path)]) == 0
    assert capsys.readouterr().out == "bash\n"
