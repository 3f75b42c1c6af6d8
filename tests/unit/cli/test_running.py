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


DOCKER = """\
#!/bin/bash
echo "$*" >>"${CALLS}"
case "$*" in
  "image inspect demo:latest") exit "${ABSENT}" ;;
  *Server.Version*) echo 27.1.0 ;;
esac
"""


@pytest.mark.parametrize("absent", ["0", "1"])
def test_an_image_that_was_not_built_is_never_pulled(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], absent: str
) -> None:
    """On a registry that name is somebody else's."""
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "docker").write_text(DOCKER)
    (tmp_path / "bin" / "docker").chmod(0o755)
    (tmp_path / "demo").mkdir()
    (tmp_path / "demo" / "requirements.txt").write_text("numpy\n")
    monkeypatch.setenv("PATH", str(tmp_path / "bin"), prepend=":")
    monkeypatch.setenv("CALLS", str(tmp_path / "calls"))
    monkeypatch.setenv("ABSENT", absent)
    monkeypatch.delenv("ROSLAB_IMAGE", raising=False)
    assert main.main(["run", str(tmp_path / "demo"), "--", "ls"]) == 5 * int(absent)
    called = [line for line in (tmp_path / "calls").read_text().splitlines() if line.startswith("run ")]
    if absent == "1":
        assert "there is no image demo:latest here\n  run `roslab build` first" in capsys.readouterr().err
        assert called == []
    else:
        assert "--pull=never" in called[0]
        assert called[0].endswith("demo:latest ls")
