"""Repairs of what a build finds there and not whole: a part of a library, a compiler, a package of another's name."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from failed_builds import log, repaired

CPP = {"CMakeLists.txt": "project(robot CXX)\nadd_executable(robot main.cpp)\n", "main.cpp": "int main() {}\n"}
HEADER = "/home/jovyan/robot/third_party/maths/map.cpp:3:10: fatal error: {}: No such file or directory"


def tree(folder: Path, config: str = "") -> Path:
    for name, text in {**CPP, "roslab.yaml": f"format: 3\n{config}"}.items():
        (folder / name).write_text(text)
    return folder


@pytest.mark.parametrize(
    ("config", "text", "wanted"),
    [
        ("", log("cmake .", '  Failed to find Qt5 component "OpenGL" config file at'), ["apt: [libqt5opengl5-dev]"]),
        (
            "",
            log("make", 'clang: error: unable to execute command: Executable "ld.lld" doesn\'t exist!'),
            ["apt: [lld]"],
        ),
        ("", log("pip install .", "RequiredDependencyException: jpeg"), ["apt: [libjpeg-dev]"]),
        (
            "",
            log("cmake .", '  The source directory "/tmp/sources/arm" does not appear to contain CMakeLists.txt.'),
            [],
        ),
    ],
)
def test_it_is_completed(tmp_path: Path, config: str, text: str, wanted: list[str]) -> None:
    assert [str(change) for change in repaired(tree(tmp_path, config), text).changes] == wanted


def test_a_submodule_whose_files_are_compiled_is_there(tmp_path: Path) -> None:
    module = '[submodule "maths"]\n\tpath = third_party/maths\n\turl = https://example.org/maths\n'
    (tree(tmp_path) / ".gitmodules").write_text(module)
    subprocess.run(["git", "init", "--quiet", str(tmp_path)], check=True)
    (change,) = repaired(tmp_path, log("make", HEADER.format("curl/curl.h"))).changes
    assert str(change).startswith("apt: [")


def test_a_default_that_a_newer_python_refuses_gets_an_older_one(tmp_path: Path) -> None:
    said = "ValueError: mutable default <class 'arm.Joint'> for field joint is not allowed: use default_factory"
    files = {"requirements.txt": "numpy\n", "main.py": "import numpy\n", "roslab.yaml": "base: {python: '3.11'}\n"}
    for name, text in files.items():
        (tmp_path / name).write_text(text if name != "roslab.yaml" else f"format: 3\n{text}")
    changes = repaired(tmp_path, log("python main.py", said)).changes
    assert [(change.key, change.value) for change in changes] == [("base.python", "3.10")]
