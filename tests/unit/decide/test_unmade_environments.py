"""What an environment of conda that is not made has of torch comes by pip where the project does not name it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROJECT = "[project]\nname = 'walk'\nversion = '1'\ndependencies = [{}]\n"
ENVIRONMENT = "channels: [pytorch]\ndependencies:\n  - python=3.10\n  - pytorch\n  - torchvision\n  - pandas\n"
FILES = {
    "pyproject.toml": PROJECT.format("'scipy'"),
    "environment.yml": ENVIRONMENT,
    "walk/__init__.py": "import torch\n",
    "README.md": "```\npip install -e .\n```\n",
}
PAGE = "```\nconda env create -f environment.yml\npip install -e .\n```\n"


def guessed(decision: Decision) -> list[str]:
    return [each.written for each in decision.python.pip_guessed]


def warned(decision: Decision) -> list[str]:
    return [each.message.partition(";")[0] for each in decision.warnings if "is not made" in each.message]


@pytest.mark.parametrize(
    ("more", "found"),
    [
        ({}, ["torch", "torchvision"]),
        ({"walk/__init__.py": ""}, ["torch", "torchvision"]),
        ({"pyproject.toml": PROJECT.format("'scipy', 'torch'")}, ["torchvision"]),
        ({"pyproject.toml": PROJECT.format("'torch', 'torchvision'")}, []),
        ({"requirements.txt": "scipy\n"}, ["torch"]),
        ({"environment.yml": "dependencies:\n  - pandas\n"}, ["torch"]),
        ({"README.md": PAGE}, []),
        ({"env.yml": ENVIRONMENT}, ["torch"]),
        ({"env_windows.yml": ENVIRONMENT}, ["torch", "torchvision"]),
    ],
    ids=["imported", "listed", "one named", "both named", "list", "none", "made", "two", "of another system"],
)
def test_the_family_of_torch_comes_by_pip(tree: Tree, more: dict[str, str], found: list[str]) -> None:
    assert [name for name in guessed(tree(FILES | more)) if name.startswith("torch")] == found


def test_it_is_told_with_the_environment(tree: Tree) -> None:
    decision = tree(FILES)
    assert warned(decision) == [
        "environment.yml is not made: the project says what it needs, and pip installs torchvision of it"
    ]
    (why,) = (each for each in decision.reasons if each.answer == "torchvision")
    assert (why.file, why.reason) == (
        "environment.yml",
        "the environment that is not made has it, and the project does not name it",
    )


def test_what_its_pins_hold_is_told_too(tree: Tree) -> None:
    environment = ENVIRONMENT.replace("- pytorch\n", "- pytorch=2.1.0\n").replace("torchvision", "torchvision=0.16.0")
    said = "pip installs torch==2.1.0 and torchvision==0.16.0 of it"
    assert warned(tree(FILES | {"environment.yml": environment})) == [
        f"environment.yml is not made: the project says what it needs, and {said}"
    ]


def test_nothing_is_said_of_pip_where_the_project_names_all(tree: Tree) -> None:
    files = {**FILES, "pyproject.toml": PROJECT.format("'torch', 'torchvision'")}
    assert warned(tree(files)) == ["environment.yml is not made: the project says what it needs"]
