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
