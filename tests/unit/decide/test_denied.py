"""A version that a page says does not work is none to take."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


def _version(tree: Tree, line: str) -> str | None:
    return tree({"README.md": f"# Demo\n\n{line}\n", "main.py": "import numpy\n"}).python.version


@pytest.mark.parametrize(
    ("line", "version"),
    [
        ("- Python 3.7 (it may not work with Python 3.8 or higher)", "3.7"),
        ("Use Python 3.9. It doesn't run on `Python 3.10+` yet.", "3.9"),
        ("Python 3.10 is not supported; we use Python 3.8", "3.8"),
        ("Python 3.6 or older is not supported. Python 3.7 works.", "3.7"),
        ("Incompatible with Python 3.12 and newer", "3.10"),
        ("Python 3.12 is unsupported.", "3.10"),
    ],
)
def test_another_one_is_taken(tree: Tree, line: str, version: str) -> None:
    assert _version(tree, line) == version


@pytest.mark.parametrize(
    ("line", "version"),
    [
        ("It works with Python 3.9 or newer", "3.9"),
        ("If you are not using Python 3.9, create an environment", "3.9"),
        ("Not only Python 3.9", "3.9"),
        ("It has not been tested with versions other than Python 3.9", "3.9"),
        ("Windows is not supported. Python 3.9", "3.9"),
        ("Python 3.9 is not required to be the system's", "3.9"),
    ],
)
def test_other_sentences_name_the_one_to_take(tree: Tree, line: str, version: str) -> None:
    assert _version(tree, line) == version


def test_a_project_knows_better(tree: Tree) -> None:
    setup = "from setuptools import setup\nsetup(name='a', python_requires='>=3.8,<3.9')\n"
    decision = tree({"README.md": "It does not work with Python 3.8 or higher\n", "setup.py": setup})
    assert decision.python.version == "3.8"
