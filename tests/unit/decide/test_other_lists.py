"""Versions of guessed packages from lists that are not installed."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CHOSEN = "name: sim\ndependencies:\n  - python=3.9\n  - numpy=1.23.3\n"
OTHER = "name: real\ndependencies:\n  - python=3.9\n  - pip:\n    - robomimic{0}\n"
FILES = {
    "train.py": "import numpy\nfrom robomimic.algo import algo_factory\nif __name__ == '__main__':\n    run()\n",
    "environment.yml": CHOSEN,
}


def guessed(decision: Decision) -> list[str]:
    return [each.written for each in decision.python.pip_guessed if each.key == "robomimic"]


@pytest.mark.parametrize(
    ("more", "written"),
    [
        ({}, "robomimic"),
        ({"environment_real.yml": OTHER.format("==0.2.0")}, "robomimic==0.2.0"),
        ({"environment_real.yml": OTHER.format("")}, "robomimic"),
        ({"environment_real.yml": "name: real\ndependencies:\n  - robomimic=0.2.0\n"}, "robomimic==0.2.0"),
        ({"environment_real.yml": "name: real\ndependencies:\n  - robomimic >=0.2, <0.3\n"}, "robomimic>=0.2,<0.3"),
        ({"requirements_real.txt": "robomimic>=0.2,<0.3\n"}, "robomimic>=0.2,<0.3"),
        ({"third_party/x/requirements.txt": "robomimic==0.1.0\n"}, "robomimic"),
        ({"tests/requirements.txt": "robomimic==0.1.0\n"}, "robomimic"),
        (
            {"real/a/environment.yml": OTHER.format("==0.2.0"), "real/b/environment.yml": OTHER.format("==0.3.0")},
            "robomimic",
        ),
    ],
    ids=["none", "pip", "open", "conda", "bounds", "list", "vendored", "tests", "contradicting"],
)
def test_a_list_that_is_not_installed_gives_the_version(tree: Tree, more: dict[str, str], written: str) -> None:
    decision = tree(FILES | more)
    assert decision.build_tool == "conda"
    assert guessed(decision) == [written]


def test_the_list_nearest_to_the_import_decides(tree: Tree) -> None:
    files = {"policy/train.py": FILES["train.py"], "environment.yml": CHOSEN}
    lists = {"requirements_real.txt": "robomimic==0.3.0\n", "policy/requirements_real.txt": "robomimic==0.2.0\n"}
    assert guessed(tree(files | lists)) == ["robomimic==0.2.0"]
