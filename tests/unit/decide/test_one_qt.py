"""Headers of Qt have one name in every Qt: what CMake requires tells which it is."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("asks", "guessed"),
    [
        ("find_package(Qt4 REQUIRED)\n", False),
        ("find_package(Qt4)\nfind_package(Qt5 COMPONENTS Widgets)\n", True),
        ("find_package(OpenCV REQUIRED)\n", True),
    ],
)
def test_qt5_is_not_guessed_beside_qt4(tree: Tree, asks: str, guessed: bool) -> None:
    cmake = f"cmake_minimum_required(VERSION 2.8)\nproject(demo)\n{asks}add_executable(demo main.cpp)\n"
    code = "#include <QApplication>\nint main() {}\n"
    decision = tree({"CMakeLists.txt": cmake, "main.cpp": code, "README.md": "Tested on Ubuntu 16.04.\n"})
    assert ("qtbase5-dev" in (*decision.apt, *decision.apt_guessed)) is guessed
