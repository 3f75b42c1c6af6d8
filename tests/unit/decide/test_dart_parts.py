"""Parts of DART whose packages leave out what their CMake targets link."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LINKED = {"libdart-external-lodepng-dev", "libdart-external-imgui-dev"}


@pytest.mark.parametrize(("part", "linked"), [("gui", LINKED), ("gui-osg", LINKED), ("utils-urdf", set())])
def test_what_the_targets_of_a_part_link_comes_with_it(tree: Tree, part: str, linked: set[str]) -> None:
    cmake = (
        "cmake_minimum_required(VERSION 3.10)\nproject(demo CXX)\n"
        f"find_package(DART 6.6.0 REQUIRED COMPONENTS {part} CONFIG)\n"
        f"add_executable(demo main.cpp)\ntarget_link_libraries(demo dart dart-{part})\n"
    )
    decision = tree({"CMakeLists.txt": cmake, "main.cpp": "int main() { return 0; }\n"})
    assert f"libdart-{part}-dev" in decision.apt
    assert {name for name in decision.apt_guessed if name.startswith("libdart-external")} == linked
