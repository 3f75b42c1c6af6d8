"""torch that CMake only tries to find, and that the code only tries to import, is not installed for it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
TRIED = "try:\n    import torch\nexcept ImportError:\n    pass\nimport numpy\n"
CMAKE = """cmake_minimum_required(VERSION 3.10)
project(view CXX)
execute_process(COMMAND python -c "import torch; print(torch.__file__)" OUTPUT_VARIABLE TorchPath)
{}
add_executable(view view.cpp)
"""
GUARDED = 'if(NOT TorchPath STREQUAL "")\n  find_package(Torch)\nendif()'


@pytest.mark.parametrize(
    ("finds", "program", "installed"),
    [
        (GUARDED, TRIED, False),
        (GUARDED, "import torch\nimport numpy\n", True),
        ("", TRIED, True),
    ],
)
def test_torch_that_is_only_tried(tree: Tree, finds: str, program: str, installed: bool) -> None:
    files = {"CMakeLists.txt": CMAKE.format(finds), "view.cpp": "int main() {}\n", "examples/balls.py": program}
    found = tree(files)
    asked = {each.key for each in (*found.python.pip, *found.python.pip_guessed)}
    assert ("torch" in asked) is installed
    assert "numpy" in asked


def test_what_a_setup_py_compiles_in_a_comment_is_nothing(tree: Tree) -> None:
    setup = "from setuptools import setup\nsetup(name='view')\n# setup(ext_modules=[CUDAExtension('view', [])])\n"
    found = tree({"setup.py": setup, "view/__init__.py": "import numpy\n"})
    assert found.kind == "python"
    assert not {each.key for each in found.python.first} & {"torch", "numpy"}
