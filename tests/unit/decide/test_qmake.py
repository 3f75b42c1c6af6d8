"""A project of qmake is a way to compile C++, where nothing else builds the tree."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROJECT = """# Created by QtCreator
QT       += core gui opengl
greaterThan(QT_MAJOR_VERSION, 4): QT += widgets multimedia
TARGET = Calibration
include(libs/gst.pri)
SOURCES += \\
    src/main.cpp
win32 {
    LIBS += -lwinmm
}
"""
FILES = {
    "app/app.pro": PROJECT,
    "app/libs/gst.pri": "LIBS += \\\n    -lgstapp-1.0\nwin32: LIBS += -lole32\n",
    "app/src/main.cpp": "#include <QApplication>\nint main() {}\n",
}
WANTED = {"qt5-qmake", "libqt5opengl5-dev", "qtmultimedia5-dev", "libgstreamer-plugins-base1.0-dev"}


def test_it_is_compiled_with_its_modules(tree: Tree) -> None:
    decision = tree({**FILES, "README.md": "# Calibration\n## Usage\n```\n./app/Calibration\n```\n"})
    assert (decision.kind, decision.build_tool) == ("cpp", "none")
    assert [(each.folder, each.command) for each in decision.scripts] == [("app", "QT_SELECT=5 qmake && make")]
    assert {*decision.apt, *decision.apt_guessed} >= WANTED  # libqt5opengl5-dev brings qtbase5-dev
    assert decision.command == ("./app/Calibration",)
    assert not [each for each in decision.warnings if "nothing shows" in each.message]


@pytest.mark.parametrize(
    "files",
    [
        {"CMakeLists.txt": "project(x)\nadd_executable(x app/src/main.cpp)\n"},
        {"app/app.pro": PROJECT + "TEMPLATE = lib\n"},
        {"app/app.pro": "some;data\n"},
        {"a.py": "import numpy\n", "b.py": "import numpy\n"},
    ],
    ids=["cmake", "library", "no-project", "python"],
)
def test_what_is_built_otherwise_is_not(tree: Tree, files: dict[str, str]) -> None:
    assert not [each for each in tree({**FILES, **files}).scripts if "qmake" in each.command]
