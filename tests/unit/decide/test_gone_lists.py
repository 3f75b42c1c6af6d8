"""The page installs a list of packages that the tree does not have."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PAGE = "# Demo\n## Install\n```\n{}pip install -r {}\n```\n"


@pytest.mark.parametrize(
    ("before", "name", "files", "told"),
    [
        ("", "requirements.txt", {}, True),
        ("", "requirements.txt", {"requirements.txt": "numpy\n"}, False),
        ("", "requirements.txt", {"docs/requirements.txt": "sphinx\n"}, False),
        ("git clone https://github.com/lab/other.git\ncd other\n", "requirements.txt", {}, False),
        ("", "path/to/list.txt", {}, False),
    ],
)
def test_it_is_told(tree: Tree, before: str, name: str, files: dict[str, str], told: bool) -> None:
    decision = tree({"main.py": "import numpy\n", "README.md": PAGE.format(before, name), **files})
    assert any("requirements.txt, which the tree does not have" in each.message for each in decision.warnings) is told
