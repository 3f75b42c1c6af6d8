"""Of a program that the tree does not have the nearest is named, and examples are listed where nothing else is one."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MAIN = "import numpy\nif __name__ == '__main__':\n    print(numpy)\n"
SETUP = "from setuptools import find_packages, setup\nsetup(name='demo', packages=find_packages())\n"
TREE = {
    "setup.py": SETUP,
    "demo/__init__.py": "import numpy\n",
    "examples/example_dqn.py": MAIN,
    "examples/example_td.py": MAIN,
}


@pytest.mark.parametrize(
    ("page", "more", "told"),
    [
        ("python3 examples/example.py", {}, ["examples/example.py"]),
        ("python3 <your folder>/example.py", {}, []),
        ("python3 setup.py develop", {}, []),
        ("python3 train.py", {"train.py": MAIN}, []),
        ("git clone https://github.com/lab/other\ncd other\npython3 other.py", {}, []),
        ("python3 other.py\npython3 train.py", {"train.py": MAIN}, []),
    ],
)
def test_what_the_page_starts(tree: Tree, page: str, more: dict[str, str], told: list[str]) -> None:
    decision = tree({**TREE, **more, "README.md": f"```\n{page}\n```\n"})
    said = [w.message.split()[3].rstrip(",") for w in decision.warnings if "which the tree does not have" in w.message]
    assert said == told


@pytest.mark.parametrize(
    ("more", "candidates"),
    [
        ({}, ["examples/example_dqn.py", "examples/example_td.py"]),
        ({"train.py": MAIN}, ["train.py"]),
    ],
)
def test_examples_are_candidates_where_nothing_else_is(tree: Tree, more: dict[str, str], candidates: list[str]) -> None:
    assert [argv[-1] for argv in tree({**TREE, **more}).command_candidates] == candidates


def test_an_example_is_no_default(tree: Tree) -> None:
    decision = tree({"setup.py": SETUP, "demo/__init__.py": "import numpy\n", "examples/a.py": MAIN})
    assert decision.command == ("bash",)
    assert decision.command_candidates == (("python3", "examples/a.py"),)
