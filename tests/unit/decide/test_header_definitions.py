"""Code that includes headers of a library which no CMake file links compiles with its headers alone."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "cmake_minimum_required(VERSION 3.10)\nproject(map)\n{}add_executable(a a.cpp)\n{}"
OPTION = "-DCMAKE_CXX_FLAGS=-DFMT_HEADER_ONLY="


@pytest.mark.parametrize(
    ("header", "before", "after", "defined"),
    [
        ("fmt/format.h", "", "", True),
        ("spdlog/spdlog.h", "", "", True),
        ("fmt/format.h", "find_package(fmt REQUIRED)\n", "", False),
        ("fmt/format.h", "", "target_link_libraries(a fmt)\n", False),
        ("spdlog/spdlog.h", "find_package(spdlog REQUIRED)\n", "", False),
        ("spdlog/spdlog.h", "find_package(fmt REQUIRED)\n", "", False),
        ("fmt/format.h", "find_package(spdlog REQUIRED)\n", "", True),
        ("format.h", "", "", False),
    ],
)
def test_headers_that_nothing_links(tree: Tree, header: str, before: str, after: str, defined: bool) -> None:
    files = {"CMakeLists.txt": CMAKE.format(before, after), "a.cpp": f"#include <{header}>\nint main() {{}}\n"}
    assert (OPTION in tree(files).cmake_options) is defined


def test_headers_of_the_tree(tree: Tree) -> None:
    files = {"CMakeLists.txt": CMAKE.format("", ""), "a.cpp": "#include <fmt/format.h>\nint main() {}\n"}
    assert OPTION not in tree({**files, "third_party/fmt/include/fmt/format.h": "\n"}).cmake_options


def test_flags_of_the_reader(tmp_path: Path) -> None:
    (tmp_path / "CMakeLists.txt").write_text(CMAKE.format("", ""))
    (tmp_path / "a.cpp").write_text("#include <fmt/format.h>\nint main() {}\n")
    evidence = gather(Repository.open(tmp_path))
    assert OPTION in decide(evidence, Config(env=(("LEVEL", "3"),)), folder_name="demo").cmake_options
    assert OPTION not in decide(evidence, Config(env=(("CXXFLAGS", "-O3"),)), folder_name="demo").cmake_options
