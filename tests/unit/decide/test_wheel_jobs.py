"""A job that builds wheels in containers tells nothing of Ubuntu by its runner; what it builds for tells of Python."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CPP = {
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.5)\nproject(demo CXX)\nadd_executable(a a.cpp)\n",
    "a.cpp": "int main() {}\n",
}
WHEELS = """jobs:
  sdist:
    runs-on: ubuntu-latest
    steps:
      - run: pipx run build --sdist
  wheels:
    runs-on: ${{ matrix.os }}
    strategy:
      matrix:
        os: [ubuntu-20.04, windows-2022]
    steps:
      - uses: USED
        env:
          CIBW_BUILD: "cp310-* cp311-*"
"""
OTHER = """  test:
    runs-on: ubuntu-24.04
    steps:
      - run: cmake .
"""


@pytest.mark.parametrize(
    ("used", "more", "ubuntu"),
    [
        ("pypa/cibuildwheel@v2.22.0", "", "jammy"),
        ("actions/checkout@v3", "", "focal"),
        ("pypa/cibuildwheel@v2.22.0", OTHER, "noble"),
    ],
)
def test_the_runner_of_wheels_is_no_ubuntu_of_the_author(tree: Tree, used: str, more: str, ubuntu: str) -> None:
    found = tree({**CPP, ".github/workflows/wheels.yml": WHEELS.replace("USED", used) + more})
    assert found.ubuntu == ubuntu


def test_wheels_tell_for_which_pythons(tree: Tree) -> None:
    page = WHEELS.replace("USED", "pypa/cibuildwheel@v2.22.0").replace("cp310-* cp311-*", "cp311-*")
    found = tree({"play.py": "import numpy\n", ".github/workflows/wheels.yml": page})
    assert found.python.version == "3.11"


@pytest.mark.parametrize(
    ("file", "text"),
    [
        (".travis.yml", "dist: bionic\nscript:\n  - python -m cibuildwheel\n"),
        (".gitlab-ci.yml", "wheels:\n  script: cibuildwheel\n"),
        (".github/workflows/a.yml", "jobs: # of wheels\n\n# cibuildwheel\n"),
        (".github/workflows/a.yml", "# cibuildwheel\njobs:\n"),
    ],
)
def test_a_file_of_ci_without_such_jobs_is_read_as_before(tree: Tree, file: str, text: str) -> None:
    assert tree({**CPP, file: text}).kind == "cpp"
