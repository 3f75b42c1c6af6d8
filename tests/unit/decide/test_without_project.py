"""A CMakeLists.txt without ``project()``, and C++ that nothing says how to compile."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LIST = "cmake_minimum_required(VERSION 2.8)\n"
CODE = {"src/main.cpp": "#include <zlib.h>\nint main() {}\n"}


@pytest.mark.parametrize(
    ("text", "tool"),
    [
        (f"{LIST}find_package(ZLIB REQUIRED)\nadd_executable(viewer main.cpp)\n", "cmake"),
        (f"{LIST}add_library(viewer main.cpp)\n", "cmake"),
        ("add_executable(viewer main.cpp)\n", "none"),  # a part of what adds its folder by a variable
        (f"{LIST}find_package(ZLIB REQUIRED)\n", "none"),
    ],
)
def test_what_adds_programs_is_a_project(tree: Tree, text: str, tool: str) -> None:
    decision = tree({"src/CMakeLists.txt": text, **CODE})
    assert (decision.kind, decision.build_tool) == ("cpp", tool)


def test_a_macro_of_an_included_module_makes_the_project(tree: Tree) -> None:
    text = f"{LIST}include(Acme)\nacme_project(\n  viewer\n  VERSION 0.1\n)\nacme_add_executables()\n"
    page = "Install Acme by [these instructions](https://github.com/someone/acme) first.\n"
    decision = tree({"CMakeLists.txt": text, "README.md": page, **CODE})
    assert (decision.kind, decision.build_tool) == ("cpp", "cmake")
    assert "acme" in [source.name for source in decision.source]


def test_a_module_of_the_tree_needs_nothing(tree: Tree) -> None:
    text = f"{LIST}include(Acme)\nacme_project(viewer)\n"
    module = "macro(acme_project NAME)\n  project(${NAME})\nendmacro()\n"
    decision = tree({"CMakeLists.txt": text, "cmake/Acme.cmake": module, **CODE})
    assert "acme" not in [source.name for source in decision.source]


def test_that_nothing_is_compiled_is_told(tree: Tree) -> None:
    told = [warning.message for warning in tree(CODE).warnings]
    assert any("nothing is compiled" in message for message in told)
    told = [warning.message for warning in tree({**CODE, "CMakeLists.txt": f"{LIST}add_library(a b.cpp)\n"}).warnings]
    assert not any("nothing is compiled" in message for message in told)
