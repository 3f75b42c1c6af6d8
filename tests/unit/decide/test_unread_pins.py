"""What pip installs from git may pin releases for the author's Python: the oldest that fits is taken beside it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
GIT = "# Install\n```\npip install git+https://github.com/acme/arm_env.git\n```\n"
OWN = "[project]\nname='a'\nversion='1'\nrequires-python='{}'\ndependencies=['numpy']\n"


@pytest.mark.parametrize(
    ("page", "asked", "python"),
    [
        (GIT, ">=3.11", "3.11"),
        ("# Install\n", ">=3.11", "3.12"),
        (GIT, ">=3.12", "3.12"),
        (GIT, ">=3.13", "3.13"),
        (GIT, ">=3.8", "3.10"),
        (GIT, "<3.10", "3.8"),
    ],
)
def test_the_python_beside_what_comes_from_git(tree: Tree, page: str, asked: str, python: str) -> None:
    files = {"README.md": page, "pyproject.toml": OWN.format(asked), "run.py": "import numpy\nimport arm_env\n"}
    assert tree(files).python.version == python
