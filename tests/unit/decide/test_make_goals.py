"""A Makefile whose first target is an object file, and what its build needs."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository

Tree = Callable[[dict[str, str]], Decision]
CODE = {"main.cpp": "#include <vector>\nint main() {}\n", "map.cpp": "#include <vector>\n"}
OBJECT = "map.o : map.cpp map.h\n\tg++ -c map.cpp\n\nmain.o: main.cpp\n\tg++ -c main.cpp -o main.o\n\n"
TEST = "test : main.o map.o\n\tg++ main.o map.o -o test"
OTHER = "view: main.o\n\t$(CXX) main.o -o $@ -lfftw3\n"


@pytest.mark.parametrize(
    ("makefile", "make", "command"),
    [
        (f"{OBJECT}{TEST}", "make test", ("./test",)),
        (f"# all\nCXX := g++\n.SUFFIXES: .o\n{OBJECT}{OTHER}", "make view", ("./view",)),
        (f"{OBJECT}{TEST}\n\n{OTHER}", "make test view", ("bash",)),
        (f"{OBJECT}lib: map.o\n\tg++ -shared map.o -o libmap.so\n{OTHER}", "make view", ("./view",)),
        (f"{TEST}\n\n{OBJECT}", "make", ("bash",)),  # it is made, and called like a task
        (f".DEFAULT_GOAL := test\n{OBJECT}{TEST}\n", "make", ("bash",)),
        (f"%.o: %.cpp\n\tg++ -c $<\n{OTHER}\n{OBJECT}", "make", ("./view",)),
        (OBJECT, "make", ("bash",)),
    ],
)
def test_what_links_is_made_where_make_would_stop_at_an_object(
    tree: Tree, makefile: str, make: str, command: tuple[str, ...]
) -> None:
    decision = tree({**CODE, "Makefile": makefile})
    assert [script.command for script in decision.scripts] == [make]
    assert decision.command == command


def test_the_target_of_a_page_comes_first(tree: Tree) -> None:
    files = {**CODE, "Makefile": f"{OBJECT}{TEST}\n\n{OTHER}"}
    page = {"README.md": "```\ncd src\nmake view\n./view\n```\n"}
    decision = tree({**{f"src/{path}": text for path, text in files.items()}, **page})
    assert [(script.folder, script.command) for script in decision.scripts] == [("src", "make view")]


@pytest.mark.parametrize(
    ("files", "cmake"),
    [
        ({}, False),
        ({"Makefile": f"{OTHER}deps:\n\t./build_deps.sh\n"}, True),
        ({"Makefile": f"{OTHER}\t$(MAKE) -C lib\n", "lib/Makefile": OTHER}, True),
        ({"README.md": "```\nsudo apt install cmake\nmake\n```\n"}, True),
    ],
)
def test_cmake_is_installed_where_something_may_call_it(tmp_path: Path, files: dict[str, str], *, cmake: bool) -> None:
    for path, text in {**CODE, "Makefile": OTHER, **files}.items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    plan = plan_repository(tmp_path).plan
    assert "build-essential" in plan.apt
    assert ("cmake" in {*plan.apt, *plan.apt_guessed}) is cmake
