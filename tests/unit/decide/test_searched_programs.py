"""Programs that CMake looks for and stops without are installed, or told where nobody knows their package."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
TOP = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\n{}\nadd_executable(demo a.cpp)\n"
NOT_FOUND = 'find_program(TOOL {0})\nif({1})\n  message(FATAL_ERROR "no {0}")\nendif()'
UBUNTU = {"README.md": "Tested on Ubuntu 22.04\n", "a.cpp": "int main() {}\n"}


def told(decision: Decision) -> list[str]:
    return [warning.message for warning in decision.warnings if "looks for the program" in warning.message]


def installed(decision: Decision) -> set[str]:
    return {*decision.apt, *decision.apt_guessed}


@pytest.mark.parametrize(
    ("body", "apt"),
    [
        ("find_program(NPM npm REQUIRED)", "npm"),
        ("find_program(NODE NAMES node nodejs REQUIRED)", "nodejs"),
        ("find_program(NODE NAMES thing nodejs HINTS /opt/bin REQUIRED)", "nodejs"),
        (NOT_FOUND.format("flex", "NOT TOOL"), "flex"),
        (NOT_FOUND.format("flex", 'TOOL STREQUAL "TOOL-NOTFOUND"'), "flex"),
        ("find_program(TOOL flex)\nif(TOOL)\n  message(STATUS x)\nelse()\n  message(FATAL_ERROR y)\nendif()", "flex"),
        ("if(UNIX)\n  find_program(DOT dot REQUIRED)\nendif()", "graphviz"),
        ("option(WEB w ON)\nif(WEB)\n  find_program(NPM npm REQUIRED)\nendif()", "npm"),
        ("find_program(NPM npm)", None),
        ("find_program(TOOL flex)\nif(NOT TOOL)\n  message(WARNING no)\nendif()", None),
        ("option(WEB w OFF)\nif(WEB)\n  find_program(NPM npm REQUIRED)\nendif()", None),
        ("if(WIN32)\n  find_program(NPM npm REQUIRED)\nendif()", None),
        ("function(web)\n  find_program(NPM npm REQUIRED)\nendfunction()", None),
        ("find_program(SH NAMES bash zsh REQUIRED)", None),
        ("find_program(PY python3 REQUIRED)", None),
    ],
)
def test_a_known_program_is_installed(tree: Tree, body: str, apt: str | None) -> None:
    decision = tree({"CMakeLists.txt": TOP.format(body), **UBUNTU})
    known = {"npm", "nodejs", "flex", "graphviz", "zsh", "python-is-python3"}
    assert installed(decision) & known == ({apt} if apt else set())
    assert not told(decision)
    reasons = [r for r in decision.reasons if apt and r.answer == apt]
    assert not apt or [(r.file, "CMake stops without a program" in r.reason) for r in reasons] == [
        ("CMakeLists.txt", True)
    ]


@pytest.mark.parametrize(
    ("body", "files", "stops"),
    [
        ("find_program(GEN acmegen REQUIRED)", {}, True),
        (NOT_FOUND.format("acmegen", "NOT TOOL"), {}, True),
        ("find_program(GEN acmegen)", {}, False),
        ("find_program(GEN NAMES acmegen HINTS tools REQUIRED)", {"tools/acmegen": "#!/bin/sh\n"}, False),
        ("add_executable(acmegen gen.cpp)\nfind_program(GEN acmegen REQUIRED)", {}, False),
        ("find_program(GEN ${NAME} REQUIRED)", {}, False),
    ],
)
def test_an_unknown_one_is_told(tree: Tree, body: str, files: dict[str, str], stops: bool) -> None:
    decision = tree({"CMakeLists.txt": TOP.format(body), **UBUNTU, **files})
    (warning,) = told(decision) or [""]
    assert bool(warning) is stops
    place = [(w.file, w.line) for w in decision.warnings if w.message == warning]
    assert not stops or ("acmegen" in warning and place == [("CMakeLists.txt", 3)])


@pytest.mark.parametrize(
    ("where", "adds", "reached"),
    [
        ("web/CMakeLists.txt", "add_subdirectory(web)", True),
        ("web/CMakeLists.txt", "", False),
        ("web/CMakeLists.txt", "option(WEB w OFF)\nif(WEB)\nadd_subdirectory(web)\nendif()", False),
        ("test/CMakeLists.txt", "add_subdirectory(test)", False),
        ("other/CMakeLists.txt", "", False),
    ],
)
@pytest.mark.parametrize("ros", [False, True])
def test_only_files_that_the_build_comes_to_count(tree: Tree, where: str, adds: str, reached: bool, ros: bool) -> None:
    body = "find_program(NPM npm REQUIRED)\nfind_program(GEN acmegen REQUIRED)\n"
    files = {"CMakeLists.txt": TOP.format(adds), where: body, **UBUNTU}
    decision = tree({**files, "package.xml": PACKAGE, "README.md": "For ROS 2 Humble\n"} if ros else files)
    assert ("npm" in installed(decision)) is reached
    assert bool(told(decision)) is reached


def test_programs_of_ros_come_with_it(tree: Tree) -> None:
    body = "find_package(ament_cmake REQUIRED)\nfind_program(XACRO xacro REQUIRED)\nfind_program(GZ gz REQUIRED)"
    decision = tree({"CMakeLists.txt": TOP.format(body), "package.xml": PACKAGE, "README.md": "For ROS 2 Humble\n"})
    assert not told(decision)
