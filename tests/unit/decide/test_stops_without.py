"""A program that stops without TensorRT is told on a base that has none of NVIDIA's package sources."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "project(a)\nfind_package(TensorRT)\nadd_executable(a a.cpp)\n"


@pytest.mark.parametrize(
    ("cmake", "said", "told"),
    [
        (CMAKE, "tensorrt not installed", True),
        (CMAKE, "TensorRT engine has bad bindings", False),
        (CMAKE, "no file", False),
        ("project(a)\nadd_executable(a a.cpp)\n", "tensorrt not installed", False),
    ],
)
def test_a_program_that_stops_without_a_library(tree: Tree, cmake: str, said: str, told: bool) -> None:
    code = f'#include <stdexcept>\nint main() {{ throw std::runtime_error("{said}"); }}\n'
    found = tree({"CMakeLists.txt": cmake, "a.cpp": code, "README.md": "Tested on Ubuntu 22.04.\n"})
    assert any("stops here without TensorRT" in each.message for each in found.warnings) is told
