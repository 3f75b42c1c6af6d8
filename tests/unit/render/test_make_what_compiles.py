"""Of many programs of which none is started, one that does not compile is left out and told."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository

TOP = "default_target: all\nall:\n\t$(MAKE) -f Makefile2 all\n"
BOTH = "all: CMakeFiles/a.dir/all tools/CMakeFiles/b.dir/all\n"
"""As CMake's generator writes it."""


@pytest.mark.usefixtures("scripts_on_path")
@pytest.mark.parametrize(
    ("first", "second", "code", "told"),
    [
        ("cp /bin/true a", "cp /bin/true b", 0, ""),
        ("cp /bin/true a", "false", 0, "roslab: not compiled and left out: b (programs that are there: 1)\n"),
        ("touch a", "false", 2, ""),
    ],
)
def test_what_compiles_is_there(tmp_path: Path, first: str, second: str, code: int, told: str) -> None:
    if shutil.which("make") is None or shutil.which("bash") is None:
        pytest.skip("an image has make and bash")
    folder = tmp_path / "build"
    folder.mkdir()
    (folder / "Makefile").write_text(TOP)
    rules = f"CMakeFiles/a.dir/all:\n\t{first}\ntools/CMakeFiles/b.dir/all:\n\t{second}\n"
    (folder / "Makefile2").write_text(BOTH + rules)
    ran = subprocess.run(["make-what-compiles", "--jobs=1"], cwd=folder, capture_output=True, text=True, check=False)
    assert (ran.returncode, ran.stderr) == (code, told)


PROGRAMS = "".join(f"add_executable(part{name} a.cpp)\n" for name in "abc")


@pytest.mark.parametrize(
    ("lines", "config", "goes_on"),
    [
        (PROGRAMS, "", True),
        ("add_executable(a a.cpp)\nadd_executable(b a.cpp)\n", "", False),
        (PROGRAMS, "command: parta\n", False),
        (f"{PROGRAMS}enable_testing()\nadd_test(NAME part COMMAND parta)\n", "", False),
    ],
)
def test_where_nothing_needs_all_of_them(tmp_path: Path, lines: str, config: str, *, goes_on: bool) -> None:
    files = {"CMakeLists.txt": f"project(demo CXX)\n{lines}", "a.cpp": "int main() {}\n"}
    files |= {"roslab.yaml": f"format: 3\n{config}"} if config else {}
    for path, text in files.items():
        (tmp_path / path).write_text(text)
    program = plan_repository(tmp_path).plan.workspace.program
    assert program is not None
    assert program.keeps_going == goes_on
