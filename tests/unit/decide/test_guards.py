"""A package that a build takes if it is there, and without which the image's program is not built."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CMAKE = """\
cmake_minimum_required(VERSION 3.5)
project(demo)
find_package(Pangolin QUIET)
{condition}
  add_executable(viewer viewer.cpp)
endif()
add_executable(other other.cpp)
"""
PAGE = "## Usage\n\n```\n./build/{program} data.bag\n```\n"


@pytest.mark.parametrize(
    ("condition", "program", "built"),
    [
        ("if(Pangolin_FOUND)", "viewer", True),
        ("if(PANGOLIN_FOUND AND UNIX)", "viewer", True),
        ("if(TARGET Pangolin::core)", "viewer", True),
        ("if(Pangolin_FOUND)", "other", False),
        ("if(NOT Pangolin_FOUND)", "viewer", False),
        ("if(Pangolin_FOUND)\nelse()", "viewer", False),
        ("if(SOMETHING)", "viewer", False),
    ],
)
def test_what_guards_the_commands_program_is_needed(tree: Tree, condition: str, program: str, built: bool) -> None:
    files = {
        "CMakeLists.txt": CMAKE.format(condition=condition),
        "viewer.cpp": "int main() {}\n",
        "other.cpp": "int main() {}\n",
        "README.md": PAGE.format(program=program),
    }
    decision = tree(files)
    assert decision.command[0] == program
    assert ("pangolin" in [source.name for source in decision.source]) == built


ALL = """\
cmake_minimum_required(VERSION 3.5)
project(demo)
find_package(Pangolin 0.2 QUIET)
find_package(OpenCV QUIET)
if(OpenCV_FOUND AND Pangolin_FOUND)
  add_executable(kitti kitti.cpp)
  add_executable(euroc euroc.cpp)
endif()
"""


@pytest.mark.parametrize(
    ("folder", "more", "built"),
    [
        ("", "", True),
        ("", "add_executable(other other.cpp)\n", False),
        ("", "if(OpenCV_FOUND)\n  add_executable(other other.cpp)\nendif()\n", False),
        ("examples/", "", False),  # the examples of a library
    ],
)
def test_what_guards_every_program_is_needed(tree: Tree, folder: str, more: str, built: bool) -> None:
    files = {f"{folder}{name}.cpp": "int main() {}\n" for name in ("kitti", "euroc", "other")}
    top = "cmake_minimum_required(VERSION 3.5)\nproject(all)\nadd_library(all all.cpp)\nadd_subdirectory(examples)\n"
    files |= {"CMakeLists.txt": top, "all.cpp": "int all() {}\n"} if folder else {}
    decision = tree({**files, f"{folder}CMakeLists.txt": ALL + more})
    assert ("pangolin" in [source.name for source in decision.source]) == built
