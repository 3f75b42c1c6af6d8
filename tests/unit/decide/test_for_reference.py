"""A list of packages that the page shows for reference only, beside its own lines."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "train.py": "import numpy\n",
    "environment.yml": "dependencies:\n- python=3.9\n- pip:\n  - odd==1.0.2\n",
    "requirements_all.txt": "odd==1.0.2\n",
}
LINES = "```\npip install tyro\n```\n"


@pytest.mark.parametrize(
    ("page", "used"),
    [
        ("Follow these lines and use `environment.yml` only as a reference.\n", False),
        ("We provide environment.yml for your reference.\n", False),
        ("Our environment is in environment.yml.\n", True),
        ("See environment.yml for reference, or:\n```\nconda env create -f environment.yml\n```\n", True),
        ("Our reference implementation needs environment.yml.\n", True),
    ],
)
def test_an_environment_that_is_shown_for_reference_is_not_made(tree: Tree, page: str, used: bool) -> None:
    decision = tree({**FILES, "README.md": f"# Install\n{page}{LINES}"})
    assert decision.python.conda_file == ("environment.yml" if used else None)
    if not used:
        assert [each.key for each in decision.python.pip_guessed] == ["tyro", "numpy"]


def test_a_list_for_reference_is_used_where_the_page_installs_nothing_itself(tree: Tree) -> None:
    page = {"README.md": "See environment.yml for reference.\n"}
    assert tree({**FILES, **page}).python.conda_file == "environment.yml"


@pytest.mark.parametrize(
    ("page", "files"),
    [
        ("What we had is in requirements_all.txt, for reference.\n", ()),
        ("What we had is in requirements_all.txt.\n", ("requirements_all.txt",)),
    ],
)
def test_a_requirement_file_may_be_for_reference(tree: Tree, page: str, files: tuple[str, ...]) -> None:
    tree_of = {path: text for path, text in FILES.items() if path != "environment.yml"}
    assert tree({**tree_of, "README.md": f"{page}{LINES}"}).python.requirements == files
