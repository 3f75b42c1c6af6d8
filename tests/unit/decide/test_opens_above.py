"""Programs of C++ that open folders of the tree from the build folder."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "project(demo)\nadd_executable(demo src/demo.cpp)\n"
RUN = "```bash\nmkdir build && cd build && cmake .. && make\n./demo\n```\n"
BELOW = "cd data && exec demo"


@pytest.mark.parametrize("page", ["", RUN])
@pytest.mark.parametrize(
    ("code", "command"),
    [
        ('std::string path = "../data/" + scene;\n', BELOW),
        ('auto a = "../lost/a.txt", b = "../data/a.txt";\n', BELOW),
        ('std::string path = "../lost/" + scene;\n', "demo"),
        ('#include "../data/a.hpp"\n', "demo"),
        ('auto a = "../data/a.txt";\nauto b = "data/a.txt";\n', "demo"),
        ('// auto a = "../data/a.txt";\n', "demo"),
    ],
)
def test_the_folder_that_it_starts_in(tree: Tree, page: str, code: str, command: str) -> None:
    decision = tree({"CMakeLists.txt": CMAKE, "src/demo.cpp": code, "data/a.txt": "1", "README.md": page})
    found = decision.command
    assert (found if isinstance(found, str) else " ".join(found)) == command


def test_a_project_in_a_folder(tree: Tree) -> None:
    code = 'auto a = "../data/a.txt";\n'
    decision = tree({"cpp/CMakeLists.txt": CMAKE, "cpp/src/demo.cpp": code, "cpp/data/a.txt": "1"})
    assert decision.command == "cd cpp/data && exec demo"


@pytest.mark.parametrize(("opens", "command"), [("a", "demo"), ("b", "cd b/data && exec demo")])
def test_programs_of_one_name_in_two_projects(tree: Tree, opens: str, command: str) -> None:
    both = {f"{folder}/CMakeLists.txt": CMAKE for folder in "ab"} | {"b/data/a.txt": "1"}
    code = {f"{each}/src/demo.cpp": 'auto a = "../data/a.txt";\n' if each == opens else "" for each in "ab"}
    found = tree(both | code).command
    assert (found if isinstance(found, str) else " ".join(found)) == command


@pytest.mark.parametrize(
    ("code", "command"),
    [
        ('std::string dir = std::getenv("PWD");\nauto files = read(dir + "/../data/scans");\n', BELOW),
        ('auto files = read(std::filesystem::current_path().string() + "/../data/scans");\n', BELOW),
        ('auto files = read(prefix + "/../data/scans");\n', "demo"),
        ('string base = "../";\nstring images = base + "data/";\n', BELOW),
        ('string base = "../";\nstring images = base + "lost/";\n', "demo"),
    ],
)
def test_paths_that_are_put_together(tree: Tree, code: str, command: str) -> None:
    decision = tree({"CMakeLists.txt": CMAKE, "src/demo.cpp": code, "data/scans/a.txt": "1"})
    found = decision.command
    assert (found if isinstance(found, str) else " ".join(found)) == command


@pytest.mark.parametrize(
    ("listed", "other", "command"),
    [
        ("src/start.cpp src/read.cpp", "", BELOW),
        ("${SOURCES}", "", BELOW),
        ("${CMAKE_CURRENT_SOURCE_DIR}/src/start.cpp src/read.cpp", "", BELOW),
        ("src/start.cpp", "", "demo"),
        ("src/start.cpp src/read.cpp", 'auto a = "data/a.txt";\n', "demo"),
    ],
    ids=["listed", "variable", "here", "of nobody", "both ways"],
)
def test_the_files_that_it_is_compiled_from(tree: Tree, listed: str, other: str, command: str) -> None:
    cmake = f"project(demo)\nset(SOURCES src/start.cpp src/read.cpp)\nadd_executable(demo {listed})\n"
    code = {"src/start.cpp": f"int main() {{}}\n{other}", "src/read.cpp": 'auto a = "../data/a.txt";\n'}
    found = tree({"CMakeLists.txt": cmake, "data/a.txt": "1"} | code).command
    assert (found if isinstance(found, str) else " ".join(found)) == command
