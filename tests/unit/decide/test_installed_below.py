"""A page at the root of a program of C++ has pip install the folder that the reader is in: the only one that can be."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CODE = {
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.10)\nproject(demo CXX)\nadd_executable(demo demo.cpp)\n",
    "demo.cpp": "int main() {}\n",
}
SETUP = "from setuptools import setup\nsetup(name='{}', packages=['{}'])\n"
PAGE = "# Demo\nIn the `py` folder:\n```\n{}\n```\n## Run\n```\npython py/run.py\n```\n"


@pytest.mark.parametrize(
    ("line", "folders", "projects"),
    [
        ("pip install -e .", ("py",), ("py",)),
        ("pip3 install .", ("py", "third_party/other"), ("py",)),
        ("pip install -e .", ("py", "other"), ()),
        ("pip install numpy", ("py",), ()),
    ],
)
def test_the_only_project_below(tree: Tree, line: str, folders: tuple[str, ...], projects: tuple[str, ...]) -> None:
    files = {f"{folder}/setup.py": SETUP.format(folder[-5:], folder[-5:]) for folder in folders}
    found = tree({**CODE, **files, "py/run.py": "import numpy\n", "README.md": PAGE.format(line)})
    assert found.kind == "cpp"
    assert found.python.projects == projects
