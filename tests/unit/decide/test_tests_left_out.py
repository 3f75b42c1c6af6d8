"""Tests of a CMake project are not compiled where they alone ask for what is not installed."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
TOP = "cmake_minimum_required(VERSION 3.16)\nproject(demo CXX)\ninclude(CTest)\nadd_executable(run run.cpp)\n"
BELOW = f"{TOP}if(BUILD_TESTING)\nadd_subdirectory(tests)\nendif()\n"
HERE = f"{TOP}if(BUILD_TESTING)\nfind_package(GTest REQUIRED)\nendif()\n"
ASKS = "find_package(GTest REQUIRED)\nadd_executable(try try.cpp)\nadd_test(try try)\n"
CODE = {"run.cpp": "int main() {}\n", "tests/try.cpp": "int main() {}\n"}


@pytest.mark.parametrize(
    ("files", "left_out"),
    [
        ({"CMakeLists.txt": BELOW, "tests/CMakeLists.txt": ASKS}, True),
        ({"CMakeLists.txt": HERE}, True),
        ({"CMakeLists.txt": BELOW, "tests/CMakeLists.txt": ASKS.replace("GTest", "Threads")}, False),
        ({"CMakeLists.txt": BELOW, "tests/CMakeLists.txt": ASKS, "apt.txt": "libgtest-dev\n"}, False),
        (
            {
                "CMakeLists.txt": BELOW,
                "tests/CMakeLists.txt": ASKS,
                "README.md": "```\ncmake -DBUILD_TESTING=ON ..\nmake\n```\n",
            },
            False,
        ),
        ({"CMakeLists.txt": TOP}, False),
    ],
    ids=["below", "guarded", "of-cmake", "installed", "asked-for", "none"],
)
def test_tests_that_lack_a_package_are_not_compiled(tree: Tree, files: dict[str, str], left_out: bool) -> None:
    decision = tree({**CODE, **files})
    assert ("-DBUILD_TESTING=OFF" in decision.cmake_options) is left_out
    assert any(warning.message.startswith("only the tests ask for GTest") for warning in decision.warnings) is left_out
    assert decision.ctest is ("tests/CMakeLists.txt" in files and not left_out)
