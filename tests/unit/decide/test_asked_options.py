"""Options that are off by themselves and without which a program is not built, as a page or CI says."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository

Tree = Callable[[dict[str, str]], Decision]
TOP = (
    "cmake_minimum_required(VERSION 3.10)\nproject(demo CXX)\nadd_library(demo a.cpp)\n"
    'option(DEMO_APPS "programs" OFF)\noption(BUILD_TESTING "tests" OFF)\noption(DEMO_FAST "fast" ON)\n'
    "if(BUILD_TESTING)\nenable_testing()\nadd_subdirectory(test)\nendif()\n"
    "if(DEMO_APPS)\nadd_executable(solve main.cpp)\nendif()\n"
)
CODE = {
    "CMakeLists.txt": TOP,
    "a.cpp": "int a() { return 1; }\n",
    "main.cpp": "int main() {}\n",
    "test/CMakeLists.txt": "add_executable(SolverTest t.cpp)\nadd_test(NAME solver COMMAND SolverTest)\n",
    "test/t.cpp": "int main() {}\n",
}
STEPS = """\
on: push
jobs:
  build:
    steps:
    - run: |
        mkdir build && cd build
        cmake -DCMAKE_PREFIX_PATH=/install \\
              {} ../
    - run: cd build && make
    - run: |
        cd build/bin
        {}
"""


@pytest.mark.parametrize(
    ("page", "options"),
    [
        ("The `SolverTest` executable is there after setting the `CMake` variable ``BUILD_TESTING`` to ``ON``.",
         ("-DBUILD_TESTING=ON",)),
        ("Programs are compiled with DEMO_APPS=ON.", ("-DDEMO_APPS=ON",)),
        ("Tests are compiled with BUILD_TESTING=ON.", ()),
        ("Programs are faster with DEMO_FAST=ON.", ()),
        ("Programs need OTHER_APPS set to ON.", ()),
        ("Set `DEMO_APPS` to `OFF` for no programs.", ()),
        ("Run the program.\n\nFor the manual set `DEMO_APPS` to `ON`.", ()),
    ],
)  # fmt: skip
def test_the_page_says_what_a_program_needs(tree: Tree, page: str, options: tuple[str, ...]) -> None:
    assert tree({**CODE, "README.md": f"# Demo\n\n{page}\n"}).cmake_options == options


@pytest.mark.parametrize(
    ("given", "run", "options"),
    [
        ("-DBUILD_TESTING:BOOL=ON", "OMP_NUM_THREADS=1 xvfb-run ./SolverTest", ("-DBUILD_TESTING=ON",)),
        ("-DDEMO_APPS=ON", "bin/solve", ("-DDEMO_APPS=ON",)),
        ("-DDEMO_APPS=ON", "ctest", ()),
        ("-DDEMO_APPS=ON", "./run.sh", ()),
        ("-DDEMO_APPS=OFF", "./solve", ()),
        ("-DOTHER=ON", "./solve", ()),
    ],
)
def test_ci_configures_with_it_before_it_runs_a_program(
    tree: Tree, given: str, run: str, options: tuple[str, ...]
) -> None:
    assert tree({**CODE, ".github/workflows/ci.yml": STEPS.format(given, run)}).cmake_options == options


def test_the_options_of_a_library_in_ci_are_its_own(tree: Tree) -> None:
    steps = STEPS.format("-DDEMO_APPS=ON", "./solve").replace(
        "mkdir build &&", "git clone https://github.com/a/lib && mkdir build &&"
    )
    assert tree({**CODE, ".github/workflows/ci.yml": steps}).cmake_options == ()


SAID = "The program `SolverTest` is there with BUILD_TESTING set to ON.\n"


@pytest.mark.parametrize(
    ("files", "given", "proved"),
    [
        ({}, "", False),
        ({"README.md": SAID}, "", True),
        ({"README.md": "```\nmkdir build && cd build\ncmake -DBUILD_TESTING=ON ..\n```\n"}, "", True),
        ({}, "format: 3\nbuild_args: -DBUILD_TESTING=ON\n", True),
        ({}, "format: 3\ncmake_options: -DBUILD_TESTING=ON\n", True),
        ({"README.md": SAID}, "format: 3\ncmake_options: -DBUILD_TESTING=OFF\n", False),
        ({"CMakeLists.txt": TOP.replace('"tests" OFF', '"tests" ON')}, "", True),
    ],
)
def test_ctest_is_a_proof_where_tests_are_built(
    tmp_path: Path, files: dict[str, str], given: str, *, proved: bool
) -> None:
    for path, text in {**CODE, **files, **({"roslab.yaml": given} if given else {})}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    proofs = [each.name for each in plan_repository(tmp_path).plan.proofs]
    assert ("the repository's tests of CMake" in proofs) is proved
