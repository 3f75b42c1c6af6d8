"""The script that compiles once more without warnings that count as errors."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts/warnings-pass.sh"
COMPILER = """\
#!/bin/bash
echo tried
if grep --quiet --recursive --extended-regexp "$STOPS" src; then
  echo "$SAID" >&2
  exit 2
fi
"""
TREATED = "cc1plus: all warnings being treated as errors"
NAMED = "a.cpp:3:7: error: unused variable 'a' [-Werror=unused-variable]"


def _run(folder: Path, files: dict[str, str], stops: str, said: str) -> tuple[int, int, str]:
    """Return the exit code, how often it was compiled, and what is printed."""
    for path, text in files.items():
        file = folder / "src" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    compiler = folder / "compile"
    compiler.write_text(COMPILER)
    compiler.chmod(0o755)
    ran = subprocess.run(
        ["bash", SCRIPT, "src", compiler],
        cwd=folder,
        env=os.environ | {"STOPS": stops, "SAID": said},
        capture_output=True,
        text=True,
        check=False,
    )
    return ran.returncode, ran.stdout.splitlines().count("tried"), ran.stdout


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("add_compile_options(-Wall -Werror -Wextra)\n", "add_compile_options(-Wall -Wno-error -Wextra)\n"),
        (
            'set(CMAKE_CXX_FLAGS "-Werror -Werror=sign-compare")\n',
            'set(CMAKE_CXX_FLAGS "-Wno-error -Wno-error=sign-compare")\n',
        ),
        ("check_cxx_compiler_flag(-Werror HAS)\n", "check_cxx_compiler_flag(-Wno-error HAS)\n"),
        ("list(APPEND F -Wall;-Werror)\n", "list(APPEND F -Wall;-Wno-error)\n"),
        ("set(CMAKE_COMPILE_WARNING_AS_ERROR ON)\n", "set(CMAKE_COMPILE_WARNING_AS_ERROR OFF)\n"),
        (
            "set_target_properties(a PROPERTIES COMPILE_WARNING_AS_ERROR TRUE)\n",
            "set_target_properties(a PROPERTIES COMPILE_WARNING_AS_ERROR OFF)\n",
        ),
    ],
)
@pytest.mark.parametrize("said", [TREATED, NAMED])
def test_a_warning_that_stops_it_stops_nothing_the_second_time(
    tmp_path: Path, before: str, after: str, said: str
) -> None:
    stops = r"[^-]-Werror|AS_ERROR (ON|TRUE)"
    code, tried, printed = _run(tmp_path, {"CMakeLists.txt": before, "a/more.cmake": before}, stops, said)
    assert (code, tried) == (0, 2), printed
    assert (tmp_path / "src/CMakeLists.txt").read_text() == (tmp_path / "src/a/more.cmake").read_text() == after
    assert "roslab:   src/a/more.cmake" in printed


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("add_compile_options(-Werror)\n", "a.cpp:1:1: error: nothing of the sort"),
        ("add_compile_options(-Wno-error)\n", NAMED),
        ("set(NVCC --Werror all-warnings)\n", NAMED),
    ],
)
def test_what_fails_otherwise_fails_once(tmp_path: Path, text: str, said: str) -> None:
    code, tried, _ = _run(tmp_path, {"CMakeLists.txt": text}, ".", said)
    assert (code, tried) == (2, 1)
    assert (tmp_path / "src/CMakeLists.txt").read_text() == text


def test_what_fails_again_fails(tmp_path: Path) -> None:
    assert _run(tmp_path, {"Makefile": "F = -Werror\n"}, ".", TREATED)[:2] == (2, 2)


def test_what_compiles_is_left_alone(tmp_path: Path) -> None:
    assert _run(tmp_path, {"CMakeLists.txt": "add_compile_options(-Werror)\n"}, "nothing", TREATED)[:2] == (0, 1)
    assert "-Werror" in (tmp_path / "src/CMakeLists.txt").read_text()
