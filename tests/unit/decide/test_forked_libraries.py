"""A fork of a known library that a page compiles, and what a page has CMake find where it was compiled."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FORK = "https://github.com/lab/gtsam.git"
OURS = "https://github.com/borglab/gtsam.git"
CLONE = "git clone -b 4.2-lab https://github.com/lab/gtsam.git\ncd gtsam && mkdir build && cd build\ncmake ..\n"
FOUND = "make\ncd ~/src/demo && mkdir build && cd build\ncmake .. -DGTSAM_DIR=WORK/gtsam/build\nmake\n"


def cpp(page: str, asked: str = "GTSAM") -> dict[str, str]:
    made = f"project(demo CXX)\nfind_package({asked} REQUIRED)\nadd_executable(demo demo.cpp)\n"
    return {"CMakeLists.txt": made, "demo.cpp": "int main() {}\n", "README.md": f"```\n{page}```\n"}


@pytest.mark.parametrize(
    ("page", "repo"),
    [
        (f"{CLONE}make install\n", FORK),
        (f"{CLONE}{FOUND}", FORK),
        (f"{CLONE}{FOUND}".replace("-DGTSAM_DIR", "-DGTSAM_DIR:PATH"), FORK),
        (f"{CLONE}{FOUND}".replace("-b 4.2-lab ", ""), OURS),  # its newest commit may be for another release
        (f"{CLONE}{FOUND}".replace("4.2-lab", "master"), OURS),
        (f"{CLONE}make install\n".replace("lab/gtsam", "lab/iris"), OURS),
        (f"{CLONE}{FOUND}".replace("WORK/gtsam/build", "WORK/other/build"), OURS),
        (CLONE, OURS),
    ],
)
def test_a_fork_that_a_page_compiles_at_a_ref_is_the_library(tree: Tree, page: str, repo: str) -> None:
    (source,) = [each for each in tree(cpp(page)).source if each.name == "gtsam"]
    assert (source.repo, source.ref == "4.2-lab") == (repo, repo == FORK)
    assert "-DGTSAM_BUILD_TESTS=OFF" in source.cmake_options.split()


def test_the_commands_may_be_items_of_a_list(tree: Tree) -> None:
    steps = "".join(f"  * `{line}`\n" for line in f"{CLONE}{FOUND}".splitlines())
    files = cpp("") | {"README.md": f"1. Build GTSAM\n{steps}"}
    assert [(each.repo, each.ref) for each in tree(files).source] == [(FORK, "4.2-lab")]


def test_what_cmake_finds_where_it_was_compiled_is_built_with_its_options(tree: Tree) -> None:
    page = (
        "git clone -b v2 https://github.com/lab/acmelib.git\ncd acmelib\nmkdir build\ncd build\n"
        "cmake -DWITH_GUI=OFF -DDATA=/data/acme ..\nmake\ncd ../..\n"
        "git clone https://github.com/lab/demo.git\ncd demo/build\ncmake -Dacmelib_DIR=../../acmelib/build ..\nmake\n"
    )
    (source,) = tree(cpp(page, "acmelib")).source
    assert (source.name, source.ref, source.cmake_options) == ("acmelib", "v2", "-DWITH_GUI=OFF")


def test_archives_of_the_table_have_no_ref(tree: Tree) -> None:
    page = CLONE.replace("gtsam", "onnxruntime").replace("cmake ..", "cmake ../cmake")
    (source,) = tree(cpp(f"{page}make install\n", "onnxruntime")).source
    assert bool(source.zip)
    assert not source.ref
