"""An address of git for pip: the origin's own means the tree itself, and that of a fork what it is a fork of."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(("name", "guessed"), [("d4rl-1", False), ("d4rl", False), ("other-1", True)])
def test_a_fork_brings_the_module_of_what_it_is_a_fork_of(tree: Tree, name: str, *, guessed: bool) -> None:
    asked = f"numpy\ngit+https://github.com/somebody/{name}.git\n"
    found = tree({"play.py": "import d4rl\n", "requirements.txt": asked})
    assert ("d4rl" in [each.key for each in found.python.pip_guessed]) is guessed


ORIGIN = {".git/config": '[remote "origin"]\n\turl = git@github.com:Lab/Sift.git\n'}
PROJECT = {"python/pyproject.toml": '[build-system]\nrequires = ["setuptools"]\n[project]\nname = "lab_sift"\n'}


@pytest.mark.parametrize(
    ("address", "guessed"),
    [
        ("https://github.com/lab/sift.git#subdirectory=python", False),
        ("https://github.com/Lab/Sift@v1", False),
        ("ssh://git@github.com/lab/sift.git", False),
        ("https://github.com/lab/sieve.git#subdirectory=python", True),
    ],
)
def test_the_own_address_is_the_tree_itself(tree: Tree, address: str, *, guessed: bool) -> None:
    page = {"README.md": f'```\npip3 install "git+{address}"\n```\n'}
    found = tree({**PROJECT, **ORIGIN, **page, "play.py": "import numpy\n"})
    assert any("git+" in each.text for each in (*found.python.pip, *found.python.pip_guessed)) is guessed
