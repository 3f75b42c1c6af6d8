"""Projects that poetry-core or flit_core refuses to install: what they need is installed all the same."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
POETRY = """[tool.poetry]
name = "my-paper"
{more}
[tool.poetry.dependencies]
python = "^3.9"
numpy = "^1.24"
[build-system]
requires = ["poetry-core"]
build-backend = "poetry.core.masonry.api"
"""
FLIT = """[build-system]
requires = ["flit_core"]
build-backend = "flit_core.buildapi"
[project]
name = "Docs"
dynamic = ["version", "description"]
{more}
"""
README = "# Paper\n## Usage\n```\npoetry install\npython train.py\n```\n"


@pytest.mark.parametrize(
    ("project", "files", "installed"),
    [
        (POETRY.format(more="package-mode = false"), {}, False),
        (POETRY.format(more="package-mode = false"), {"my_paper/__init__.py": ""}, False),
        (POETRY.format(more=""), {}, False),
        (POETRY.format(more=""), {"my_paper/__init__.py": ""}, True),
        (POETRY.format(more=""), {"src/my_paper/core.py": ""}, True),
        (POETRY.format(more=""), {"my_paper.py": ""}, True),
        (POETRY.format(more="packages = [{include = 'core'}]"), {"core/__init__.py": ""}, True),
        (FLIT.format(more=""), {}, False),
        (FLIT.format(more=""), {"docs/__init__.py": ""}, True),
        (FLIT.format(more='[tool.flit.module]\nname = "core"'), {"core/__init__.py": ""}, True),
    ],
    ids=[
        "mode",
        "mode-with-module",
        "poetry",
        "package",
        "src",
        "file",
        "packages",
        "flit",
        "flit-package",
        "flit-name",
    ],
)
def test_what_a_backend_refuses_is_not_installed(
    tree: Tree, project: str, files: dict[str, str], installed: bool
) -> None:
    decision = tree({"pyproject.toml": project, "train.py": "import numpy\n", "README.md": README, **files})
    assert bool(decision.python.projects) is installed
    if "numpy" in project and not installed:
        asked = [*decision.python.pip, *decision.python.pip_guessed]
        assert [str(each.specifier) for each in asked if each.key == "numpy"] == ["<2,>=1.24"]
