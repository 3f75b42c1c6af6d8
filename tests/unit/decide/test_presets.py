"""A preset of CMake that a page names stands for the options of CMakePresets.json."""

from __future__ import annotations

import json
from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CMAKE = """cmake_minimum_required(VERSION 3.21)
project(demo)
set(DEMO_API gl CACHE STRING "")
add_executable(demo main.cpp)
if(DEMO_GUI)
  add_executable(demo_gui main.cpp)
endif()
install(TARGETS demo)
"""
PRESETS = {
    "version": 3,
    "configurePresets": [
        {"name": "base", "hidden": True, "cacheVariables": {"DEMO_TESTS": True, "DEMO_GUI": False, "DEMO_API": "gl"}},
        {"name": "release", "inherits": ["base"], "cacheVariables": {"CMAKE_BUILD_TYPE": "Release"}},
        {
            "name": "gui",
            "inherits": "release",
            "cacheVariables": {
                "DEMO_GUI": {"type": "BOOL", "value": "ON"},
                "DEMO_DIR": "${sourceDir}/a",
                "DEMO_X": None,
            },
        },
        {"name": "loop", "inherits": "loop", "cacheVariables": {"DEMO_GUI": True}},
    ],
}


def files(call: str, presets: str) -> dict[str, str]:
    page = f"## Build\n```\n{call}\ncmake --build --preset gui\n```\n"
    return {"CMakeLists.txt": CMAKE, "main.cpp": "int main() {}\n", "README.md": page, "CMakePresets.json": presets}


@pytest.mark.parametrize(
    ("call", "options"),
    [
        ("cmake --preset gui", ("-DDEMO_GUI=ON", "-DDEMO_API=gl")),
        ("cmake --preset=release", ("-DDEMO_GUI=OFF", "-DDEMO_API=gl")),
        ("cmake --preset gui -DDEMO_API=vulkan", ("-DDEMO_API=vulkan", "-DDEMO_GUI=ON")),
        ("cmake --preset another", ()),
        ("cmake --preset loop", ("-DDEMO_GUI=ON",)),
    ],
)
def test_its_variables_are_given(tree: Tree, call: str, options: tuple[str, ...]) -> None:
    assert tree(files(call, json.dumps(PRESETS))).cmake_options == options


@pytest.mark.parametrize(
    "text", ["", "[1]", '{"configurePresets": 3}', '{"configurePresets": [{"name": "gui", "inherits": 3}]}']
)
def test_a_file_that_cannot_be_read_gives_none(tree: Tree, text: str) -> None:
    assert tree(files("cmake --preset gui", text)).cmake_options == ()


def test_a_library_that_is_configured_by_a_preset_is_configured_where_it_lies(tree: Tree) -> None:
    build = "cd odd && cmake --preset gui && cmake --build build && sudo cmake --install build"
    page = f"```\ngit clone https://github.com/lab/odd.git\n{build}\n```\n"
    cmake = "project(demo)\nfind_package(odd REQUIRED)\nadd_executable(demo main.cpp)\n"
    (source,) = tree({"CMakeLists.txt": cmake, "main.cpp": "int main() {}\n", "README.md": page}).source
    assert (source.name, source.cmake_folder) == ("odd", None)
