"""A header of the compiler that a source uses and does not include is told to the compiler."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.knowledge.standard_headers import MissedHeader, missed_headers, standard_headers

Tree = Callable[[dict[str, str]], Decision]
NOBLE = "cmake_minimum_required(VERSION 3.28)\nproject(demo)\nadd_executable(a a.cpp)\n"
FOCAL = NOBLE.replace("3.28", "3.16") + "# Ubuntu 20.04\n"
MAX = "double most = DBL_MAX;\n"


def flags(decision: Decision) -> str:
    return dict(decision.variables).get("CXXFLAGS", "")


@pytest.mark.parametrize(
    ("code", "told"),
    [
        (f"#include <vector>\n{MAX}", "-include cfloat"),
        ("#include <iostream>\nvoid f(char *a) {\n  memset(a, 0, 1);\n}\n", "-include cstring"),
        ("#include <string>\nstruct A { uint8_t kind; };\nint most = INT_MAX;\n", "-include climits -include cstdint"),
        ("#include <vector>\nint f() { return std::numeric_limits<int>::max(); }\n", "-include limits"),
        (f"#include <float.h>\n{MAX}", ""),
        (f"#include <Eigen/Core>\n{MAX}", ""),
        (f"#include <vector>\n// {MAX}", ""),
        (f"#include <vector>\n#ifdef _WIN32\n{MAX}#endif\n", ""),
        (f"#include <vector>\n#define DBL_MAX 1e300\n{MAX}", ""),
        ("#include <vector>\nconstexpr int INT_MAX = 7;\nint most = INT_MAX;\n", ""),
        ("#include <vector>\nvoid memset(int);\nstruct A { void strlen(); };\nvoid f(A a) { a.strlen(); }\n", ""),
        ("#include <chrono>\nuint8_t kind;\n", ""),
    ],
)
def test_what_a_source_uses_without_its_header_is_included(tree: Tree, code: str, told: str) -> None:
    assert flags(tree({"CMakeLists.txt": NOBLE, "a.cpp": code})) == told


@pytest.mark.parametrize(
    ("header", "told"), [("#include <cfloat>\n", ""), ("#include <vector>\n", "yes"), ("#include <ros/ros.h>\n", "")]
)
def test_headers_of_the_tree_bring_what_they_include(tree: Tree, header: str, told: str) -> None:
    cmake = NOBLE + "include_directories(include)\n"
    files = {"CMakeLists.txt": cmake, "include/a/a.h": header, "a.cpp": f'#include "a/a.h"\n{MAX}'}
    assert bool(flags(tree(files))) is bool(told)


def test_a_header_of_the_tree_that_uses_it_is_named(tree: Tree) -> None:
    decision = tree({"CMakeLists.txt": NOBLE, "a.h": f"#pragma once\n{MAX}", "a.cpp": '#include "a.h"\n'})
    said = next(each for each in decision.reasons if each.answer == "CXXFLAGS=-include cfloat")
    assert (said.file, said.line, said.reason) == ("a.h", 2, "DBL_MAX is used without <cfloat>")


@pytest.mark.parametrize("files", [{"a.c": MAX}, {"a.cpp": "", "b.cpp": MAX}, {"a.cpp": "", "docs/b.cpp": MAX}])
def test_what_nothing_compiles_as_cpp_lacks_nothing(tree: Tree, files: dict[str, str]) -> None:
    assert not flags(tree({"CMakeLists.txt": NOBLE, **files}))


def test_an_older_gcc_brings_it_along(tree: Tree) -> None:
    code = {"a.cpp": "#include <string>\nuint8_t kind;\n", "README.md": "Ubuntu 20.04\n"}
    decision = tree({"CMakeLists.txt": FOCAL, **code})
    assert decision.ubuntu == "focal"
    assert not flags(decision)


@pytest.mark.skipif(shutil.which("g++") is None, reason="g++ is not installed")
@pytest.mark.parametrize("missed", missed_headers(), ids=[row.header for row in missed_headers()])
def test_the_header_has_the_names(missed: MissedHeader, tmp_path: Path) -> None:
    snippets = {
        "cfloat": MAX,
        "climits": "int most = INT_MAX;",
        "cstring": "int f(char *a) {\nstrlen(a);\nreturn 0; }",
        "cstdint": "uint8_t kind;",
        "limits": "int most = std::numeric_limits<int>::max();",
        "memory": "std::shared_ptr<int> a;",
        "functional": "std::function<void()> a;",
    }
    code = snippets[missed.header]
    assert missed.names.search(code)
    assert any(each in code for each in missed.has)
    command = ["g++", "-std=c++17", "-fsyntax-only", "-x", "c++"]
    (tmp_path / "a.cpp").write_text(code)
    assert subprocess.run([*command, "a.cpp"], cwd=tmp_path, capture_output=True, check=False).returncode
    subprocess.run([*command, "-include", missed.header, "a.cpp"], cwd=tmp_path, check=True)


def test_each_missed_header_brings_itself() -> None:
    known = {row.header for row in missed_headers()}
    assert all(row in standard_headers()[row] for row in known)
    assert frozenset().union(*standard_headers().values()) <= known
