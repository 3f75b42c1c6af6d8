"""``roslab explain --apply``: what it writes, and what it leaves alone."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.cli.main import main

MISSING = """\
#6 [3/4] RUN make
#6 1.2 /home/jovyan/robot/main.cpp:1:13: fatal error: glog/logging.h: No such file or directory
#6 ERROR: process "/bin/sh -c make" did not complete successfully: exit code: 2
"""
NOTE = "  # for the header glog/logging.h (main.cpp:1)"
OTHER = """\
#6 [3/4] RUN git clone https://example.org/gone
#6 1.2 fatal: repository 'https://example.org/gone/' not found
#6 ERROR: process "/bin/sh -c git clone https://example.org/gone" did not complete successfully: exit code: 128
"""


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    folder = tmp_path / "robot"
    folder.mkdir()
    (folder / "CMakeLists.txt").write_text("project(robot CXX)\nadd_executable(robot main.cpp)\n")
    (folder / "main.cpp").write_text("#define LOG <glog/logging.h>\n#include LOG\nint main() {}\n")
    return folder


def explain(robot: Path, log: str, *more: str) -> int:
    file = robot.parent / "build.log"
    file.write_text(log)
    return main(["explain", str(file), str(robot), *more])


def test_nothing_is_written_unasked(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert explain(robot, MISSING) == 0
    out = capsys.readouterr().out
    assert "adds apt: [libgoogle-glog-dev], for the header glog/logging.h (main.cpp:1)" in out
    assert "  apt:\n    - libgoogle-glog-dev" in out
    assert not (robot / "roslab.yaml").exists()


def test_a_new_file_holds_what_was_missing(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert explain(robot, MISSING, "--apply") == 0
    assert "+  - libgoogle-glog-dev" in capsys.readouterr().err
    assert (robot / "roslab.yaml").read_text() == f"format: 3\napt:\n  - libgoogle-glog-dev{NOTE}\n"


def test_an_existing_file_keeps_its_comments_and_its_old_self(robot: Path) -> None:
    (robot / "roslab.yaml").write_text("format: 3\napt:\n  - git # for vcs\n")
    assert explain(robot, MISSING, "--apply") == 0
    assert (robot / "roslab.yaml").read_text() == f"format: 3\napt:\n  - git # for vcs\n  - libgoogle-glog-dev{NOTE}\n"
    assert (robot / "roslab.yaml.old").read_text() == "format: 3\napt:\n  - git # for vcs\n"
    assert explain(robot, MISSING, "--apply") == 5, "it is there already: another repair is needed"


def test_what_has_no_certain_lines_is_not_written(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert explain(robot, OTHER, "--apply") == 5
    assert "nothing is written" in capsys.readouterr().err
    assert not (robot / "roslab.yaml").exists()


def test_an_image_of_the_author_s_own_dockerfile_is_repaired_there(
    robot: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (robot / "Dockerfile").write_text("FROM ubuntu:22.04\nCOPY . /src\nRUN make\n")
    (robot / "roslab.yaml").write_text("format: 3\ndockerfile: Dockerfile\n")
    assert explain(robot, MISSING, "--apply") == 5
    told = capsys.readouterr()
    assert "+RUN apt-get update && apt-get install -y --no-install-recommends libgoogle-glog-dev\n RUN make" in told.out
    assert "nothing is written: the image is built from Dockerfile" in told.err
    assert (robot / "roslab.yaml").read_text() == "format: 3\ndockerfile: Dockerfile\n"
