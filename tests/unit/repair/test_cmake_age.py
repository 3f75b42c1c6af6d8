"""A CMake that does not know a command, module, policy or expression is raised to the first release that does."""

from __future__ import annotations

from pathlib import Path

import pytest

from failed_builds import log, repaired
from roslab.explain.cmake_age import since

CPP = {"CMakeLists.txt": "project(arm CXX)\nadd_executable(arm main.cpp)\n", "main.cpp": "int main() {}\n"}
UNKNOWN = {
    "a command": ('  Unknown CMake command "target_link_options".', "3.13.0"),
    "a command of a module": ('  Unknown CMake command "FetchContent_MakeAvailable".', "3.14.0"),
    "a sub-command": ("  string does not recognize sub-command JSON", "3.19.0"),
    "another sub-command": ("  file does not recognize sub-command CONFIGURE", "3.18.0"),
    "a module": ("  include could not find load file:\n\n    FetchContent", "3.11.0"),
    "a module of find_package": ('  By not providing "FindCUDAToolkit.cmake" in CMAKE_MODULE_PATH this', "3.17.0"),
    "a policy": ('  Policy "CMP0135" is not known to this version of CMake.', "3.24.0"),
    "an expression": (
        (
            "  Error evaluating generator expression:\n\n    $<LINK_LANGUAGE:C>\n\n"
            "  Expression did not evaluate to a known generator expression"
        ),
        "3.18.0",
    ),
    "a property": (
        '  INTERFACE_LIBRARY targets may only have whitelisted properties.  The\n  property "OWNER" is not allowed.',
        "3.19.0",
    ),
    "an install": ('  install TARGETS given no LIBRARY DESTINATION for shared library target\n  "arm".', "3.14.0"),
    "another folder's target": (
        '  Attempt to add link library "m" to target "arm" which is not built in this\n  directory.',
        "3.13.0",
    ),
}


@pytest.mark.parametrize("what", UNKNOWN)
def test_cmake_is_raised_to_the_release_that_knows_it(what: str, tmp_path: Path) -> None:
    said, wanted = UNKNOWN[what]
    for name, text in CPP.items():
        (tmp_path / name).write_text(text)
    text = log("cmake .", "CMake Error at CMakeLists.txt:3 (arm):", *said.split("\n"), "-- Configuring incomplete")
    found = repaired(tmp_path, text)
    assert [f"{change.key}: {change.value}" for change in found.changes] == [f"base.cmake_update: {wanted}"]


def test_a_command_of_a_package_says_nothing_of_cmake() -> None:
    assert since({"command": "catkin_package"}) == {}
    assert since({"call": "string", "words": "FIND"}) == {}
    assert since({"find": "Ceres"}) == {}
    assert since({}) == {}
