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


@pytest.mark.parametrize(
    ("asks", "package", "other"),
    [
        ("find_package(Qt6 REQUIRED COMPONENTS Core Qml)\n", "qt6-declarative-dev", "qtdeclarative5-dev"),
        ("find_package(Qt5 REQUIRED COMPONENTS Core Qml)\n", "qtdeclarative5-dev", "qt6-declarative-dev"),
        ("find_package(OpenCV REQUIRED)\n", "qtdeclarative5-dev", "qt6-declarative-dev"),
    ],
)
def test_a_header_of_a_component_is_brought_by_it(tree: Tree, asks: str, package: str, other: str) -> None:
    cmake = f"cmake_minimum_required(VERSION 3.16)\nproject(demo)\n{asks}add_executable(demo main.cpp)\n"
    code = "#include <QtQml/qqmlregistration.h>\nint main() {}\n"
    decision = tree({"CMakeLists.txt": cmake, "main.cpp": code, "README.md": "Tested on Ubuntu 24.04.\n"})
    found = {*decision.apt, *decision.apt_guessed}
    assert package in found
    assert other not in found
    assert not [each for each in decision.warnings if "QtQml" in each.message]


@pytest.mark.parametrize(("ubuntu", "package"), [("16.04", "libncurses5-dev"), ("24.04", "libncurses-dev")])
def test_curses_by_the_name_of_its_time(tree: Tree, ubuntu: str, package: str) -> None:
    cmake = (
        "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package(Curses REQUIRED)\nadd_executable(d a.cpp)\n"
    )
    decision = tree({"CMakeLists.txt": cmake, "a.cpp": "int main() {}\n", "README.md": f"Tested on Ubuntu {ubuntu}.\n"})
    assert package in decision.apt


@pytest.mark.parametrize(
    ("ubuntu", "packages"),
    [
        ("22.04", {"libqt6svg6-dev", "libqt6websockets6-dev"}),
        ("24.04", {"qt6-svg-dev", "qt6-websockets-dev"}),
    ],
)
def test_parts_of_qt6_by_the_names_of_their_ubuntu(tree: Tree, ubuntu: str, packages: set[str]) -> None:
    cmake = (
        "cmake_minimum_required(VERSION 3.16)\nproject(demo CXX)\n"
        "find_package(Qt6 REQUIRED COMPONENTS Svg WebSockets)\nadd_executable(d a.cpp)\n"
    )
    page = f"Tested on Ubuntu {ubuntu}.\n"
    decision = tree({"CMakeLists.txt": cmake, "a.cpp": "int main() {}\n", "README.md": page})
    assert packages <= {*decision.apt, *decision.apt_guessed}
    assert not [each for each in decision.warnings if "Qt6" in each.message]
