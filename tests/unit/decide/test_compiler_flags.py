"""Flags of the compiler with which a page configures a library are one option, with all of its words."""

from __future__ import annotations

import shlex
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.prose.configured import options_of
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package(g2o REQUIRED)\nadd_executable(a a.cpp)\n"
PAGE = """```
git clone https://github.com/RainerKuemmerle/g2o.git
cd g2o && mkdir build && cd build
cmake -DCMAKE_CXX_FLAGS="{}" -D G2O_USE_OPENMP=ON ..
sudo make install
```
"""


@pytest.mark.parametrize(
    ("said", "kept"),
    [
        ("-DA -DB=1 -fopenmp", "-DCMAKE_CXX_FLAGS=-DA -DB=1 -fopenmp"),
        ("-O3 -march=native -mavx2 -Werror", "-DCMAKE_CXX_FLAGS=-O3"),
        ("-std=c++17", "-DCMAKE_CXX_FLAGS=-std=c++17"),
        ("-march=native", None),
        ("-O3; rm -rf /", None),
        ("$FLAGS -O3", None),
    ],
)
def test_flags_are_one_word_of_the_library(tree: Tree, said: str, kept: str | None) -> None:
    decision = tree({"CMakeLists.txt": CMAKE, "a.cpp": "int main() {}\n", "README.md": PAGE.format(said)})
    library = next(source for source in decision.source if source.name == "g2o")
    words = shlex.split(library.cmake_options)
    assert [word for word in words if "FLAGS" in word] == ([kept] if kept else [])
    assert "-DG2O_USE_OPENMP=ON" in words


def test_flags_of_a_library_that_no_table_knows(tmp_path: Path) -> None:
    page = PAGE.format("-O3 -w").replace("RainerKuemmerle/g2o", "lab/acmelib").replace("cd g2o", "cd acmelib")
    (tmp_path / "README.md").write_text(page)
    (tmp_path / "CMakeLists.txt").write_text(CMAKE.replace("g2o", "acmelib"))
    (tmp_path / "a.cpp").write_text("int main() {}\n")
    assert "'-DCMAKE_CXX_FLAGS=-O3 -w' -DG2O_USE_OPENMP=ON ../" in dockerfile(plan_repository(tmp_path).plan)


def test_an_option_of_a_project_that_is_called_like_flags_stays_as_it_is() -> None:
    assert options_of(["cmake", "-DUSE_FLAGS=ON", "-DNAME=a b", "-D", "GUI:=OFF", ".."]) == "-DUSE_FLAGS=ON -DGUI=OFF"


def test_flags_of_what_lies_in_the_tree(tmp_path: Path) -> None:
    page = '```\ncd Thirdparty/fast && mkdir build && cd build\ncmake .. -DCMAKE_CXX_FLAGS="-O2 -fopenmp"\nmake\n```\n'
    files = {
        "CMakeLists.txt": CMAKE.replace("find_package(g2o REQUIRED)\n", ""),
        "a.cpp": "int main() {}\n",
        "Thirdparty/fast/CMakeLists.txt": "project(fast)\nadd_library(fast f.cpp)\n",
        "Thirdparty/fast/f.cpp": "int f;\n",
        "README.md": page,
    }
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    assert "'-DCMAKE_CXX_FLAGS=-O2 -fopenmp' .." in dockerfile(plan_repository(tmp_path).plan)
