"""A list of packages at the root that only the page of a part asks for, beside a project that pip installs alone."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROJECT = '[project]\nname = "demo"\nversion = "1.0"\ndependencies = ["numpy"]\n'
FILES = {
    "pyproject.toml": PROJECT,
    "requirements.txt": "numpy\ntensorflow-graphics\n",
    "demo/__init__.py": "",
    "README.md": "# Demo\n```\npip install .\n```\n",
}
TRAINING = {"demo/training/README.md": "```\npip install -r demo/requirements.txt\n```\n"}


@pytest.mark.parametrize(
    ("more", "installed"),
    [
        (TRAINING, ()),
        ({}, ("requirements.txt",)),  # no page asks for it: it may be meant for all
        (TRAINING | {"README.md": "```\npip install .\npip install -r requirements.txt\n```\n"}, ("requirements.txt",)),
        (TRAINING | {"README.md": "# Demo\n"}, ("requirements.txt",)),
        ({"docs/install.md": "```\npip install -r requirements.txt\n```\n"}, ("requirements.txt",)),
        (
            TRAINING | {".github/workflows/test.yml": "a:\n  - run: pip install -r requirements.txt\n"},
            ("requirements.txt",),
        ),
        (TRAINING | {"pyproject.toml": PROJECT.replace('"numpy"', "")}, ("requirements.txt",)),
    ],
)
def test_a_list_that_only_the_page_of_a_part_asks_for(
    tree: Tree, more: dict[str, str], installed: tuple[str, ...]
) -> None:
    decision = tree(FILES | more)
    assert decision.python.requirements == installed
    assert any("only pages of folders" in told.message for told in decision.warnings) == (not installed)
