"""A build file that changes: the build tree is made anew, and of its files only what is another is compiled again."""

from __future__ import annotations

import re
import secrets
import subprocess
import sys
from pathlib import Path

import pytest

from .laboratory import Laboratory

SCRIPTS = Path(__file__).resolve().parent.parent.parent / "scripts"
FILES = 12
"""As many as are worth a cache."""
PROGRAM = """\
cmake_minimum_required(VERSION 3.5)
project(robot CXX)
file(GLOB parts *.cpp)
add_executable(robot ${parts})
"""
WORKSPACE = PROGRAM.replace("file(", "find_package(catkin REQUIRED)\ncatkin_package()\nfile(")
PACKAGE = """\
<package format="2"><name>robot</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.org">a</maintainer><license>MIT</license><buildtool_depend>catkin</buildtool_depend>
</package>
"""
KINDS = {
    "workspace": {
        "roslab.yaml": "format: 3\nbase:\n  ros: noetic\ncommand: rosrun robot robot\n",
        "package.xml": PACKAGE,
        "CMakeLists.txt": WORKSPACE,
    },
    "program": {
        "roslab.yaml": "format: 3\nkind: cpp\nbase:\n  image: ros:noetic-ros-base\ncommand: robot\n",
        "CMakeLists.txt": PROGRAM,
    },
}


def write(folder: Path, files: dict[str, str]) -> None:
    folder.mkdir(exist_ok=True)
    for name, text in files.items():
        (folder / name).write_text(text)


def build(lab: Laboratory, folder: Path) -> str:
    """Return what ``roslab build`` says; the image is removed."""
    command = [sys.executable, "-I", str(SCRIPTS), "build", str(folder), "--tag", "repro-lab", "--no-repair"]
    names = {name: value for name, value in lab.environment.items() if not name.startswith(("GITHUB_", "ROSLAB_"))}
    done = subprocess.run(command, env=names, capture_output=True, text=True, timeout=1800, check=False)
    assert done.returncode == 0, done.stderr[-8000:]
    remove = ["docker", "image", "rm", done.stdout.strip()]
    subprocess.run(remove, env=dict(lab.environment), check=False, capture_output=True)
    return done.stderr


@pytest.mark.parametrize("kind", list(KINDS))
def test_files_that_did_not_change_are_compiled_once(lab: Laboratory, tmp_path: Path, kind: str) -> None:
    folder = tmp_path / f"compiled-{kind}-{secrets.token_hex(4)}"  # the cache is the image's, by its name
    parts = {f"part{number}.cpp": f"int part{number}() {{ return {number}; }}\n" for number in range(FILES)}
    write(folder, {**KINDS[kind], **parts, "main.cpp": "int part1();\nint main() { return part1() - 1; }\n"})
    first = build(lab, folder)
    assert "left out: ccache" not in first
    assert "compiled by an earlier build" not in first
    cmake = (folder / "CMakeLists.txt").read_text()
    changed = {
        "CMakeLists.txt": f"{cmake}# another\n",
        "part2.cpp": "int part2() { return 22; }\n",
        "new.cpp": "int x;\n",
    }
    write(folder, changed)
    second = build(lab, folder)
    assert "only code has changed" not in second
    assert re.findall(r"roslab: (\d+) files were compiled by an earlier build", second) == [str(FILES)]
