"""What an author's list has from his Windows or macOS: pip finds none of it on Linux."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository

MAIN = "import numpy\nif __name__ == '__main__':\n    print('a')\n"


def told(folder: Path, lines: str) -> tuple[tuple[str, ...], list[str]]:
    (folder / "requirements.txt").write_text(lines)
    (folder / "main.py").write_text(MAIN)
    plan = plan_repository(folder).plan
    return plan.python.pip, [each.message for each in plan.warnings]


@pytest.mark.parametrize(
    "line", ["pywin32==304", "windows-curses", "tensorflow-intel==2.13.0", "kivy_deps.sdl2==0.7.0"]
)
def test_a_package_for_windows_is_left_out_and_told(tmp_path: Path, line: str) -> None:
    pip, warnings = told(tmp_path, f"numpy==1.26.4\n{line}\n")
    assert pip == ("numpy==1.26.4",)
    (warning,) = warnings
    assert warning.startswith(f"pip cannot install {line.partition('==')[0].replace('_', '-').replace('.', '-')[:7]}")
    assert "for Windows alone; the image is built without it (" in warning


def test_a_line_that_says_so_itself_is_left_to_pip(tmp_path: Path) -> None:
    assert told(tmp_path, "numpy\npywin32==304; sys_platform == 'win32'\n") == ((), [])


def test_a_package_for_macos_is_the_usual_one_in_the_same_release(tmp_path: Path) -> None:
    pip, _ = told(tmp_path, "numpy\ntensorflow-macos==2.13.0\n")
    assert pip == ("numpy", "tensorflow>=2.13.0,<3")
