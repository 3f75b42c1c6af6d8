"""Of many programs of which none is started, one that does not compile is left out and told."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

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
    command = ["make-what-compiles", "make", "--jobs=1"]
    ran = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert (ran.returncode, ran.stderr) == (code, told)


@pytest.mark.usefixtures("scripts_on_path")
def test_one_that_stops_at_a_warning_alone_is_there(tmp_path: Path) -> None:
    """Of three, one does not compile at all, and one only as long as a warning counts as an error."""
    if shutil.which("make") is None or shutil.which("bash") is None:
        pytest.skip("an image has make and bash")
    (tmp_path / "Makefile").write_text("FLAGS = -Werror\ninclude rules\n")
    names = {"a": "cp /bin/true a", "b": "cp /bin/true b", "c": "false"}
    rules = "".join(f"CMakeFiles/{name}.dir/all:\n\t{made}\n" for name, made in names.items())
    strict = '@if [ "$(FLAGS)" = -Werror ]; then echo "[-Werror=unused]"; exit 1; fi\n\tcp /bin/true b'
    rules = rules.replace(names["b"], strict)
    (tmp_path / "rules").write_text(f"all: {' '.join(f'CMakeFiles/{name}.dir/all' for name in names)}\n{rules}")
    command = ["make-what-compiles", "warnings-pass", str(tmp_path), "make", "--jobs=1"]
    ran = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert ran.returncode == 0
    assert ran.stderr == "roslab: not compiled and left out: c (programs that are there: 2)\n"
    assert (tmp_path / "b").exists()


@pytest.mark.usefixtures("scripts_on_path")
@pytest.mark.parametrize(("needed", "code"), [("a", 0), ("b", 2)])
def test_the_program_that_is_started_has_to_be_there(tmp_path: Path, needed: str, code: int) -> None:
    if shutil.which("make") is None or shutil.which("bash") is None:
        pytest.skip("an image has make and bash")
    (tmp_path / "Makefile").write_text("all: a b\na:\n\tcp /bin/true a\nb:\n\tfalse\n")
    command = ["make-what-compiles", "--program", needed, "make", "--jobs=1"]
    assert subprocess.run(command, cwd=tmp_path, capture_output=True, check=False).returncode == code


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


def test_a_warning_is_looked_at_before_a_program_is_left_out(tmp_path: Path) -> None:
    (tmp_path / "CMakeLists.txt").write_text(f"project(demo CXX)\nadd_compile_options(-Werror)\n{PROGRAMS}")
    (tmp_path / "a.cpp").write_text("int main() {}\n")
    assert " && make-what-compiles warnings-pass /home/" in dockerfile(plan_repository(tmp_path).plan)


HEAD = "https://github.com/google/googletest/archive/master.zip"


@pytest.mark.parametrize(
    ("url", "more", "readme", "called"),
    [
        (HEAD, "", "./demo fast", "make-what-compiles --program demo "),
        (HEAD.replace("master", "refs/heads/main"), "", "./demo fast", "make-what-compiles --program demo "),
        (HEAD.replace("master", "release-1.8.1"), "", "./demo fast", ""),
        (HEAD.replace("master", "3f0cf6b62ad1eb50d8736538363d3580dd640c3e"), "", "./demo fast", ""),
        (HEAD, "EXCLUDE_FROM_ALL 1", "./demo fast", ""),
        (HEAD, "", "python3 plot.py", "make-what-compiles make "),
    ],
)
def test_the_archive_of_a_branch_may_not_compile(tmp_path: Path, url: str, more: str, readme: str, called: str) -> None:
    lists = f"include(ExternalProject)\nExternalProject_Add(gtest\n  URL {url}\n  {more})\nadd_executable(demo a.cpp)\n"
    page = f"```\nmkdir build && cd build\ncmake .. && make\n{readme}\n```\n"
    files = {"CMakeLists.txt": f"project(demo CXX)\n{lists}", "a.cpp": "int main() {}\n", "README.md": page}
    for path, text in (files | {"plot.py": "import math\nprint(math.pi)\n"}).items():
        (tmp_path / path).write_text(text)
    plan = plan_repository(tmp_path).plan
    whole = dockerfile(plan)
    assert ("make-what-compiles" in whole) == bool(called)
    assert f"&& {called}" in whole
    told = [(each.file, each.line) for each in plan.warnings if "another one each time" in each.message]
    assert told == [("CMakeLists.txt", 3)] * bool(called)


@pytest.mark.parametrize("command", ["bash run.sh", "[bash, run.sh]", "[sh, run.sh]", "python3 run.py"])
def test_nothing_tells_what_another_command_needs(tmp_path: Path, command: str) -> None:
    lists = (
        f"project(demo CXX)\ninclude(ExternalProject)\nExternalProject_Add(gtest URL {HEAD})\nadd_executable(a a.cpp)\n"
    )
    files = {"CMakeLists.txt": lists, "a.cpp": "int main() {}\n", "roslab.yaml": f"format: 3\ncommand: {command}\n"}
    for path, text in files.items():
        (tmp_path / path).write_text(text)
    assert "make-what-compiles" not in dockerfile(plan_repository(tmp_path).plan)
