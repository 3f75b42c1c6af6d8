"""Boost's headers that need no compiled library bring no more than headers."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
BOOST = {"libboost-dev", "libboost-all-dev"}


@pytest.mark.parametrize(
    ("code", "find", "installed"),
    [
        ("#include <boost/bind.hpp>\n#include <boost/ref.hpp>\n", "", {"libboost-dev"}),
        ("#include <boost/bind.hpp>\n#include <boost/thread.hpp>\n", "", {"libboost-all-dev"}),
        ("#include <boost/bind.hpp>\n", "find_package(Boost REQUIRED COMPONENTS system)\n", {"libboost-all-dev"}),
    ],
    ids=["headers", "a compiled one", "CMake"],
)
def test_headers_alone_need_no_compiled_library(tree: Tree, code: str, find: str, installed: set[str]) -> None:
    cmake = f"project(arm CXX)\n{find}add_executable(arm a.cpp)\n"
    decision = tree({"CMakeLists.txt": cmake, "a.cpp": f"{code}int main() {{}}\n"})
    assert {*decision.apt, *decision.apt_guessed} & BOOST == installed
