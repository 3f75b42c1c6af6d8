"""What ``.python-version`` names."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("named", "readme", "version"),
    [
        ("3.11\n", "", "3.11"),
        ("3.11.4\n", "Python 3.10 is what we used.\n", "3.11"),
        ("3.11\n", "```\nconda create -n demo python=3.12\n```\n", "3.12"),
        ("my-environment\n", "", "3.10"),
        ("3.9\n", "", "3.10"),
    ],
)
def test_the_file_that_uv_and_pyenv_obey(tree: Tree, named: str, readme: str, version: str) -> None:
    project = '[project]\nname = "demo"\nversion = "1"\nrequires-python = ">=3.10"\ndependencies = ["typer"]\n'
    files = {"pyproject.toml": project, "demo.py": "import typer\n", ".python-version": named, "README.md": readme}
    assert tree(files).python.version == version
