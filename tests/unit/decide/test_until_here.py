"""A section about another system that goes on with what is the same on this one."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.prose.headings import lines_of, resumed

Tree = Callable[[dict[str, str]], Decision]
CODE = {
    "CMakeLists.txt": "project(demo CXX)\nadd_executable(train a.cpp)\nadd_executable(show a.cpp)\n",
    "a.cpp": "int main() {}\n",
}
MACOS = "# Demo\n## Build\n### Packages on macOS\n```\nbrew install hdf5\n```\n{}Then\n```\n./build/train --fast\n```\n"


@pytest.mark.parametrize(
    ("item", "run"),
    [
        ("- Ubuntu: `cmake ..`\n- macOS: `cmake .. -DA=1`\n", True),
        ("* **Ubuntu + OpenBLAS:** `cmake .. -DB=ON`\n", True),
        ("1. On Linux: `cmake ..`\n", True),
        ("- macOS: `cmake ..`\n", False),
        ("- Linux: see above\n", False),
        ("Ubuntu needs none of this.\n", False),
        ("```\n- Ubuntu: `cmake ..`\n```\n", False),
        ("", False),
    ],
)
def test_it_is_for_all_from_an_item_with_a_command_for_this_one_on(tree: Tree, item: str, run: bool) -> None:
    command = tree(CODE | {"README.md": MACOS.format(item)}).command
    assert (command == ("train", "--fast")) is run


@pytest.mark.parametrize("title", ["Uninstall", "Citation"])
def test_a_section_about_something_else_does_not(tree: Tree, title: str) -> None:
    page = MACOS.format("- Ubuntu: `cmake ..`\n").replace("Packages on macOS", title)
    assert tree(CODE | {"README.md": page}).command != ("train", "--fast")


@pytest.mark.parametrize(("between", "number"), [("", 3), ("And so:\n", 7), ("\n", 3)])
def test_the_block_right_above_the_item_is_for_all_too(between: str, number: int) -> None:
    page = f"## Packages on macOS\nNow:\n```\nmkdir build\n```\n{between}- Ubuntu: `cmake ..`\n- macOS: `cmake ..`\n"
    assert resumed(page.split("\n")) == {number}
    assert next(line.number for line in lines_of(page) if not line.elsewhere) in {number, number + 1}
