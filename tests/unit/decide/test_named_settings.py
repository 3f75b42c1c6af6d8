"""A file of settings that a page names and the tree has with YAML's other ending, and folders that the page makes."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "CMakeLists.txt": "project(demo CXX)\nadd_executable(run_demo a.cpp)\n",
    "a.cpp": "int main() {}\n",
    "run.py": "import yaml\n\nif __name__ == '__main__':\n    print(1)\n",
}


def page(lines: str) -> dict[str, str]:
    return {"README.md": f"# Demo\n## Run\n```\n{lines}\n```\n"}


@pytest.mark.parametrize(
    ("line", "there", "command", "told"),
    [
        ("./build/run_demo cfg/a.yml", "cfg/a.yaml", ("run_demo", "cfg/a.yaml"), False),
        ("./build/run_demo cfg/a.yaml", "cfg/a.yml", ("run_demo", "cfg/a.yml"), False),
        ("./build/run_demo cfg/a.yml", "cfg/a.yml", ("run_demo", "cfg/a.yml"), False),
        ("./build/run_demo cfg/a.yml", "cfg/b.yaml", ("run_demo", "cfg/a.yml"), True),
        ("./build/run_demo /data/a.yml", "cfg/b.yaml", ("run_demo", "/data/a.yml"), False),
        ("./build/run_demo --out a.yml", "a.json", ("run_demo", "--out", "a.yml"), False),
    ],
)
def test_the_other_ending_of_yaml(tree: Tree, line: str, there: str, command: tuple[str, ...], *, told: bool) -> None:
    decision = tree(FILES | page(line) | {there: "a: 1\n"})
    assert decision.command == command
    assert any("neither the tree nor a download" in w.message for w in decision.warnings) is told
    said = next(r.reason for r in decision.reasons if r.question == "command")
    assert ("which the tree lacks" in said) is (not told and command[-1] == there != line.rpartition(" ")[2])


@pytest.mark.parametrize(
    ("lines", "command"),
    [
        ("mkdir output\n./build/run_demo a", "mkdir -p output && exec run_demo a"),
        ("mkdir -p out/a out/b && ./build/run_demo a", "mkdir -p out/a out/b && exec run_demo a"),
        ("mkdir build\ncd build\ncmake ..\nmake\n./run_demo a", ("run_demo", "a")),
        ("mkdir build && cd build && cmake .. && make && ./run_demo a", ("run_demo", "a")),
        ("mkdir out && cd out\n../build/run_demo a", ("run_demo", "a")),
        ("mkdir ~/data\n./build/run_demo a", ("run_demo", "a")),
    ],
)
def test_the_folders_that_the_page_makes_right_before(tree: Tree, lines: str, command: tuple[str, ...] | str) -> None:
    assert tree(FILES | page(lines)).command == command
