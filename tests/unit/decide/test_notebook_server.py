"""A notebook is opened by the server that the tree declares."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
NOTEBOOK = '{"cells": [], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}'
ENVIRONMENT = "name: a\nchannels: [conda-forge]\ndependencies:\n  - python=3.11\n{}"


@pytest.mark.parametrize(
    ("files", "server"),
    [
        ({"environment.yml": ENVIRONMENT.format("  - jupyterlab>=3.5\n")}, "lab"),
        ({"environment.yml": ENVIRONMENT.format("  - jupyterlab\n  - notebook\n")}, "notebook"),
        ({"requirements.txt": "numpy\njupyterlab==4.1\n"}, "lab"),
        ({"requirements.txt": "numpy\njupyter\njupyterlab\n"}, "notebook"),
        ({"requirements.txt": "numpy\n"}, "notebook"),
    ],
)
@pytest.mark.parametrize(
    "page", ["# A\n\n```sh\njupyter notebook show.ipynb\n```\n", "# A\n\nSee [this](show.ipynb).\n", "# A\n"]
)
def test_the_declared_server_opens_a_notebook(tree: Tree, files: dict[str, str], server: str, page: str) -> None:
    decision = tree({**files, "README.md": page, "show.ipynb": NOTEBOOK})
    assert decision.command[:2] == ("jupyter", server)
    assert decision.command[-1] == "show.ipynb"
    assert decision.ports == ("8888",)
    guessed = {each.key for each in decision.python.pip_guessed}
    assert ("notebook" in guessed) is (files == {"requirements.txt": "numpy\n"})


def test_a_server_that_only_a_page_names_is_installed(tree: Tree) -> None:
    page = "# A\n\n```sh\npip install jupyterlab\njupyter lab show.ipynb\n```\n"
    decision = tree({"README.md": page, "show.ipynb": NOTEBOOK, "requirements.txt": "numpy\n"})
    assert decision.command[:2] == ("jupyter", "lab")
    assert "jupyterlab" in {each.key for each in decision.python.pip_guessed}
