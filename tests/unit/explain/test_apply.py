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
    said = capsys.readouterr().err
    assert "+  - libgoogle-glog-dev" in said
    assert said.endswith(f"roslab: written to {robot / 'roslab.yaml'}\n")
    assert (robot / "roslab.yaml").read_text() == f"format: 3\napt:\n  - libgoogle-glog-dev{NOTE}\n"


def test_an_existing_file_keeps_its_comments_and_its_old_self(robot: Path) -> None:
    (robot / "roslab.yaml").write_text("format: 3\napt:\n  - git # for vcs\n")
    assert explain(robot, MISSING, "--apply") == 0
    assert (robot / "roslab.yaml").read_text() == f"format: 3\napt:\n  - git # for vcs\n  - libgoogle-glog-dev{NOTE}\n"
    assert (robot / "roslab.yaml.old").read_text() == "format: 3\napt:\n  - git # for vcs\n"
    assert explain(robot, MISSING, "--apply") == 5, "it is there already: another repair is needed"


def test_what_is_planned_already_is_not_added(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (robot / "CMakeLists.txt").write_text(
        "project(robot CXX)\nfind_package(glog REQUIRED)\nadd_executable(robot main.cpp)\n"
    )
    there = (
        "apt: [libgoogle-glog-dev] is in the planned image already: the log is of another one, or it does not help\n"
    )
    assert explain(robot, MISSING, "--apply") == 5
    told = capsys.readouterr()
    assert f"nothing to add: {there}" in told.out
    assert "adds apt" not in told.out
    assert told.err.endswith(f"  {there}")
    assert not (robot / "roslab.yaml").exists()


def test_what_roslab_yaml_has_already_is_told_unasked(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (robot / "roslab.yaml").write_text("format: 3\napt: [libgoogle-glog-dev]\n")
    assert explain(robot, MISSING) == 0
    assert (
        "nothing to add: roslab.yaml has libgoogle-glog-dev already, and that did not help\n" in capsys.readouterr().out
    )


def test_what_has_no_certain_lines_is_not_written(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert explain(robot, OTHER, "--apply") == 5
    assert "nothing is written" in capsys.readouterr().err
    assert not (robot / "roslab.yaml").exists()


def test_what_somebody_wrote_is_told_and_stays(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = "format: 3\nkind: python\nbase: {python: '3.12'}\n"
    (robot / "roslab.yaml").write_text(text)
    assert explain(robot, "Starting\nModuleNotFoundError: No module named 'imp'\n", "--apply") == 5
    told = capsys.readouterr()
    assert "may need base.python: 3.12 becomes 3.11, for imp, which Python has up to 3.11" in told.out
    assert "which is yours to exchange" in told.err
    assert (robot / "roslab.yaml").read_text() == text


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


def test_a_log_alone_shows_what_to_change_in_a_dockerfile(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "build.log"
    file.write_text(MISSING)
    assert main(["explain", str(file)]) == 0
    added = "  +RUN apt-get update && apt-get install -y --no-install-recommends libgoogle-glog-dev\n   RUN make\n"
    assert capsys.readouterr().out.endswith(f"roslab.yaml: apt: [libgoogle-glog-dev]\nin the Dockerfile:\n{added}")


def test_what_is_unknown_stays_short_and_can_be_tried(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    said = "".join(f"#6 {n}.0 the strange thing number {n} failed\n" for n in range(60))
    end = '#6 ERROR: process "/bin/sh -c ./odd" did not complete successfully: exit code: 7\n'
    file = tmp_path / "build.log"
    file.write_text(f"#6 [3/4] RUN ./odd\n{said}{end}")
    assert main(["explain", str(file)]) == 0
    out = capsys.readouterr().out.splitlines()
    assert out[:2] == ["step: RUN ./odd", "no known cause. The lines that matter:"]
    assert 1 <= len([line for line in out if line.startswith("  ")]) <= 20
    assert out[-1].endswith("docker buildx debug --invoke /bin/sh build .")


def test_a_folder_in_place_of_the_log_is_told_the_order(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", str(robot), "build.log"]) == 2
    assert "Is a directory\n  the log, a file, comes first, then the repository" in capsys.readouterr().err
