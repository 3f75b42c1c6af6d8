"""Projects of the tree that CMake requires by their names in other letters."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
XML = (
    "<package format='3'><name>{0}</name><buildtool_depend>ament_cmake</buildtool_depend>"
    "<export><build_type>ament_cmake</build_type></export></package>"
)
AMENT = "cmake_minimum_required(VERSION 3.8)\nproject({0})\nfind_package(ament_cmake REQUIRED)\n{1}ament_package()\n"
PLAIN = "cmake_minimum_required(VERSION 3.8)\nproject({0})\nadd_library(foozle a.cpp)\n{1}"
FILES = "install(FILES {0} DESTINATION lib/cmake/foozle)\n"


def app(asked: str) -> dict[str, str]:
    cmake = AMENT.format("app", f"find_package({asked} REQUIRED)\n")
    return {"README.md": "ROS 2 humble\n", "app/package.xml": XML.format("app"), "app/CMakeLists.txt": cmake}


@pytest.mark.parametrize(
    ("project", "install", "asked", "told"),
    [
        ("Foozle", "", "FOOZLE", False),
        ("foozle", "", "Foozle", False),
        ("Foozle", FILES.format("foozle-config.cmake"), "FOOZLE", False),
        ("Foozle", FILES.format("FoozleConfig.cmake"), "Foozle", False),
        ("Foozle", FILES.format("FoozleConfig.cmake"), "FOOZLE", True),
        ("Bar", "", "FOOZLE", True),
    ],
)
def test_a_project_of_cmake(tree: Tree, project: str, install: str, asked: str, told: bool) -> None:
    files = {"foozle/CMakeLists.txt": PLAIN.format(project, install), "foozle/a.cpp": "int a() { return 1; }\n"}
    messages = [each.message for each in tree({**app(asked), **files}).warnings]
    told_so = (f"nothing is known that brings {asked}", f"CMake requires {asked}, and the tree has")
    assert any(message.startswith(told_so) for message in messages) is told


def test_one_that_pip_compiles(tree: Tree) -> None:
    files = {
        "pyproject.toml": "[build-system]\nrequires = ['scikit-build-core']\n[project]\nname = 'a'\nversion = '1'\n",
        "CMakeLists.txt": "project(top)\nadd_subdirectory(foozle)\nfind_package(FOOZLE REQUIRED)\n",
        "foozle/CMakeLists.txt": PLAIN.format("Foozle", ""),
    }
    assert not any("FOOZLE" in each.message for each in tree(files).warnings)


def test_a_package_of_ros_is_found_by_its_letters_alone(tree: Tree) -> None:
    files = {"foozle/package.xml": XML.format("foozle"), "foozle/CMakeLists.txt": AMENT.format("foozle", "")}
    (told,) = [each for each in tree({**app("Foozle"), **files}).warnings if "Foozle" in each.message]
    assert told.message == (
        "CMake requires Foozle, and the tree has foozle: CMake tells letters apart, and app is left out of the build, "
        "which no other package needs; write foozle there"
    )
