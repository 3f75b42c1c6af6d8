"""What a library looks for that CMake compiles with the project is installed, also while it is not checked out."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MODULES = '[submodule "a"]\n\tpath = lib/window\n\turl = https://github.com/libsdl-org/SDL.git\n'
FETCH = "FetchContent_Declare(window GIT_REPOSITORY https://github.com/glfw/glfw.git GIT_TAG 3.4)\n"


@pytest.mark.parametrize(
    ("cmake", "files", "there"),
    [
        ("add_subdirectory(lib/window)\n", {".gitmodules": MODULES}, True),
        ("add_subdirectory(lib/window)\n", {"lib/window/CMakeLists.txt": "project(window)\n"}, False),
        ("", {".gitmodules": MODULES}, False),  # nothing compiles it
        ("add_subdirectory(external/glfw)\n", {"external/glfw/CMakeLists.txt": "project(GLFW)\n"}, True),
        ("add_subdirectory(glfw)\n", {"glfw/CMakeLists.txt": "add_library(glfw a.cpp)\n"}, False),  # of the project
        (f"include(FetchContent)\n{FETCH}FetchContent_MakeAvailable(window)\n", {}, True),
    ],
    ids=["submodule", "own", "unused", "copied", "own-name", "fetched"],
)
def test_headers_of_windows(tree: Tree, cmake: str, files: dict[str, str], *, there: bool) -> None:
    code = {"CMakeLists.txt": f"project(demo)\n{cmake}add_executable(demo main.cpp)\n", "main.cpp": "int main() {}\n"}
    decision = tree({**code, **files})
    assert ({"libxrandr-dev", "libxext-dev"} <= {*decision.apt, *decision.apt_guessed}) is there
