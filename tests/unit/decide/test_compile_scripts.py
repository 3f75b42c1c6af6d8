"""C, C++ and CUDA that a script of the shell compiles, which a page runs, without CMake and without a Makefile."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
ASKS = "`pkg-config --cflags --libs opencv`"
CODE = {"main.cpp": "#include <opencv2/opencv.hpp>\nint main() {}\n"}
SCRIPT = {"compile.sh": f"#!/bin/bash\n# g++ -o old old.cpp\ng++ -std=c++11 \\\n  -o slam main.cpp -lfftw3 {ASKS}\n"}
PAGE = {"README.md": "# Run\n```\n./compile.sh  # compiles it\n./slam data/00\n```\n"}


def test_what_a_script_makes_is_the_program(tree: Tree) -> None:
    found = tree({**CODE, **SCRIPT, **PAGE})
    assert (found.kind, found.build_tool, found.command) == ("cpp", "none", ("./slam", "data/00"))
    assert [(script.folder, script.command, script.required) for script in found.scripts] == [
        ("", "bash compile.sh", True)
    ]
    assert {"libopencv-dev", "libfftw3-dev", "pkg-config"} <= {*found.apt, *found.apt_guessed}


def test_what_a_script_makes_lies_where_a_page_calls_it(tree: Tree) -> None:
    files = {f"src/{path}": text for path, text in (CODE | SCRIPT).items()}
    found = tree({**files, "README.md": "```\ncd src\n./compile.sh\n./slam\n```\n"})
    assert [(script.folder, script.command) for script in found.scripts] == [("src", "bash compile.sh")]
    assert found.command == ("./src/slam",)


def test_the_only_build_stops_the_image(tmp_path: Path) -> None:
    for path, text in (CODE | SCRIPT | PAGE).items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert "bash compile.sh" in text
    assert "left out: bash compile.sh" not in text


@pytest.mark.parametrize(
    "files",
    [
        {"compile.sh": "g++ -c -o slam main.cpp\n"},
        {"compile.sh": "g++ -shared -o slam main.cpp\n"},
        {"compile.sh": "g++ -o lib/slam.so main.cpp\n"},
        {**SCRIPT, "README.md": "# Run\n```\n./slam data/00\n```\n"},
        {**SCRIPT, "setup.py": "from setuptools import setup\nsetup(name='demo')\n", "a.py": "import os\n"},
        {**SCRIPT, "Makefile": "all:\n\tg++ -o other main.cpp\n"},
    ],
)
def test_what_is_no_script_that_builds_the_tree(tree: Tree, files: dict[str, str]) -> None:
    found = tree({**CODE, **PAGE, **files})
    assert not any(script.required for script in found.scripts)


MAKE = "all:\n\tg++ -o slam main.cpp $(shell pkg-config --libs {})\n"
CMAKE = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package(PkgConfig REQUIRED)\n{}(CV REQUIRED {})\n"


@pytest.mark.parametrize(
    ("files", "ubuntu"),
    [
        ({"compile.sh": "g++ -o slam main.cpp `pkg-config --libs opencv`\n"}, "bionic"),
        ({"compile.sh": "g++ -o slam main.cpp $(pkg-config --libs opencv4)\n"}, "jammy"),
        ({"compile.sh": "g++ -o slam main.cpp # `pkg-config --libs opencv`\n"}, "jammy"),
        ({"compile.sh": "echo pkg-config opencv is missing\ng++ -o slam main.cpp\n"}, "jammy"),
        ({"compile.sh": "g++ -o slam main.cpp `pkg-config opencv4 || pkg-config opencv`\n"}, "jammy"),
        ({"compile.sh": "g++ -o slam main.cpp $(pkg-config opencv4 || pkg-config opencv)\n"}, "jammy"),
        ({"Makefile": MAKE.format("opencv")}, "bionic"),
        ({"Makefile": MAKE.format("eigen3")}, "jammy"),
        ({"CMakeLists.txt": CMAKE.format("pkg_check_modules", "opencv")}, "bionic"),
        ({"CMakeLists.txt": CMAKE.format("pkg_search_module", "opencv4 opencv")}, "jammy"),
        ({"CMakeLists.txt": CMAKE.format("pkg_check_modules", "eigen3")}, "jammy"),
    ],
)
def test_a_name_of_pkg_config_tells_the_release(tree: Tree, files: dict[str, str], ubuntu: str) -> None:
    assert tree({**CODE, **PAGE, **files}).ubuntu == ubuntu


def test_a_makefile_that_asks_pkg_config_gets_it(tree: Tree) -> None:
    found = tree({**CODE, "Makefile": MAKE.format("eigen3")})
    assert {"libeigen3-dev", "pkg-config"} <= {*found.apt, *found.apt_guessed}
