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


SDL3 = """project(demo)
find_package(SDL3 REQUIRED)
add_executable(demo main.cpp)
"""
BY_HAND = """# Demo
## Installation
```
git clone https://github.com/libsdl-org/SDL.git
cd SDL && cmake -B build && cmake --build build && sudo cmake --install build
```
"""


def test_a_library_that_a_page_compiles_has_what_its_build_looks_for(tree: Tree) -> None:
    decision = tree({"CMakeLists.txt": SDL3, "main.cpp": "int main() {}\n", "README.md": BY_HAND})
    (built,) = decision.source
    assert built.name == "SDL"
    assert {"libxrandr-dev", "libwayland-dev"} <= {*built.depends}
    assert {"libxrandr-dev", "libwayland-dev"} <= {*decision.apt, *decision.apt_guessed}  # loaded when it runs
    assert not any("SDL3" in warning.message for warning in decision.warnings)  # the name has the major release


@pytest.mark.parametrize(
    ("cmake", "page"),
    [
        (SDL3, BY_HAND.replace("cd SDL && cmake -B build && cmake --build build && sudo cmake --install build", "")),
        (SDL3.replace("SDL3", "SDLX"), BY_HAND),
        (SDL3, BY_HAND.replace("libsdl-org/SDL", "acme/SDLparts").replace("cd SDL", "cd SDLparts")),
    ],
    ids=["only-cloned", "another-name", "another-repository"],
)
def test_what_no_page_compiles_is_told(tree: Tree, cmake: str, page: str) -> None:
    decision = tree({"CMakeLists.txt": cmake, "main.cpp": "int main() {}\n", "README.md": page})
    assert any("SDL" in warning.message and "CMake requires" in warning.message for warning in decision.warnings)


def test_a_library_of_the_recipes_keeps_its_own_list(tree: Tree) -> None:
    page = BY_HAND.replace("libsdl-org/SDL", "stevenlovegrove/Pangolin").replace("cd SDL", "cd Pangolin")
    files = {"CMakeLists.txt": SDL3.replace("SDL3", "Pangolin"), "main.cpp": "int main() {}\n", "README.md": page}
    assert "libxkbcommon-dev" not in {*tree(files).apt_guessed}


HYPER = "FetchContent_Declare(v GIT_REPOSITORY https://github.com/VIS4ROB-lab/HyperVariables.git GIT_TAG e46e67af)\n"


@pytest.mark.parametrize(("ubuntu", "built"), [("20.04", ["glog"]), ("22.04", [])])
def test_what_the_cmake_of_a_fetched_library_stops_without_is_there(tree: Tree, ubuntu: str, built: list[str]) -> None:
    made = (
        f"project(demo)\ninclude(FetchContent)\n{HYPER}FetchContent_MakeAvailable(v)\nadd_executable(demo main.cpp)\n"
    )
    files = {"CMakeLists.txt": made, "main.cpp": "int main() {}\n", "README.md": f"Tested on Ubuntu {ubuntu}\n"}
    decision = tree(files)
    assert [source.name for source in decision.source] == built
    assert {"libeigen3-dev", "libgtest-dev"} <= {*decision.apt}
    assert ("libgoogle-glog-dev" in decision.apt) == (not built)
    other = tree({**files, "CMakeLists.txt": made.replace("HyperVariables", "other")})
    assert not other.source
    assert "libgtest-dev" not in other.apt
