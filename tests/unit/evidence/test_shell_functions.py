"""Functions of the repository's own scripts that start a program of ROS."""

from __future__ import annotations

from pathlib import Path

import pytest

from hanging import ends
from roslab.evidence.prose.shell_functions import functions
from roslab.repository.checkout import Repository

CALL = 'ros2 run recorder record "$@"'


def found(folder: Path, text: str) -> dict[str, str]:
    (folder / "a.sh").write_text(text, newline="")
    return functions(Repository.open(folder))


@pytest.mark.parametrize(
    "body", ["{ %s; }", "{ %s }", "{ %s ;}", "{\n  %s\n}", "{\n\n\t%s;\n\n}", "{\r\n  %s\r\n}", "{%s  }", "{ %s; \n}"]
)
def test_a_function_of_one_command(tmp_path: Path, body: str) -> None:
    assert found(tmp_path, f"record() {body % CALL}\n") == {"record": "ros2 run recorder record"}


@pytest.mark.parametrize("body", ["{\n  cd a\n  %s\n}", "{ cd a; %s; }", "{\n  %s\n  echo a\n}"])
def test_one_of_several_commands_is_none(tmp_path: Path, body: str) -> None:
    assert found(tmp_path, f"record() {body % CALL}\n") == {}


@pytest.mark.parametrize("blanks", [" " * 1_500, "\n" * 1_500, "\t\n" * 1_500], ids=["blanks", "lines", "both"])
def test_many_blanks_take_no_time(tmp_path: Path, blanks: str) -> None:
    with ends():
        assert found(tmp_path, f"x() {{{blanks}a{blanks}b\n" * 4) == {}
