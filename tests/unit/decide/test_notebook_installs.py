"""What the cells of notebooks install, and notebooks that are large by what they printed."""

from __future__ import annotations

import json
from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.python import notebooks

Tree = Callable[[dict[str, str]], Decision]


def notebook(*lines: str, printed: int = 0, language: str = "python") -> str:
    cell = {"cell_type": "code", "source": [f"{line}\n" for line in lines], "outputs": [{"text": "x" * printed}]}
    return json.dumps({"cells": [cell], "metadata": {"language_info": {"name": language}}}, indent=1)


def guessed(found: Decision) -> set[str]:
    return {each.name for each in found.python.pip_guessed} - {"notebook"}


@pytest.mark.parametrize(
    ("line", "names"),
    [
        ("!pip install -q ikpy", {"ikpy"}),
        ("%pip install ikpy", {"ikpy"}),
        ("! python -m pip install -q -U ikpy tabulate", {"ikpy", "tabulate"}),
        ("!pip3 install ikpy==3.3", {"ikpy"}),
        ("!pip install ikpy    !pip install tabulate --upgrade", {"ikpy", "tabulate"}),  # a break that was lost
        ("# !pip install ikpy", set()),
        ("# later !pip install ikpy", set()),
        ("pip install ikpy", set()),  # no Python
        ("!pip uninstall ikpy", set()),
        ("!pip install -e .", set()),
        ("!pip install -r requirements.txt", set()),
        ("!pip install git+https://github.com/x/ikpy.git", set()),
        ("!python train.py --install", set()),
    ],
)
def test_cells_install(tree: Tree, line: str, names: set[str]) -> None:
    assert guessed(tree({"lesson/a.ipynb": notebook(line, "a = 1")})) == names


def test_cells_install_with_apt(tree: Tree) -> None:
    found = tree({"a.ipynb": notebook("!sudo apt-get install -y graphviz", "a = 1")})
    assert "graphviz" in found.apt_guessed


@pytest.mark.parametrize(
    "beside",
    [
        {"main.py": "if __name__ == '__main__':\n    print(1)\n"},
        {"pyproject.toml": "[project]\nname = 'demo'\nversion = '1'\n", "demo/__init__.py": ""},
        {"requirements.txt": "numpy\n"},
        {"environment.yml": "dependencies:\n  - numpy\n"},
    ],
)
def test_beside_other_python_a_notebook_is_for_another_machine(tree: Tree, beside: dict[str, str]) -> None:
    cells = notebook("!pip install ikpy torch==1.12.1+cu113", "a = 1")
    found = tree({"colab/a.ipynb": cells, **beside})
    assert not {"ikpy", "torch"} & {*guessed(found), *(each.name for each in found.python.pip)}
    assert found.kind == "python"


def test_other_languages_have_other_lines(tree: Tree) -> None:
    assert (
        guessed(tree({"a.ipynb": notebook("!pip install ikpy", language="julia"), "b.ipynb": notebook("a")})) == set()
    )


def test_a_notebook_is_read_whatever_it_printed(tree: Tree) -> None:
    found = tree({"a.ipynb": notebook("import tabulate", printed=2_000_000)})
    assert guessed(found) == {"tabulate"}
    assert found.command[:2] == tree({"a.ipynb": notebook("import tabulate")}).command[:2]


def test_the_size_and_the_number_of_large_ones_are_bounded(tree: Tree) -> None:
    large = notebook("import tabulate", printed=notebooks.MAX_SIZE)
    assert guessed(tree({"a.ipynb": large, "b.ipynb": notebook("import ikpy")})) == {"ikpy"}
    many = {f"n{n}.ipynb": notebook("a = 1", printed=notebooks.LARGE) for n in range(notebooks.MAX_LARGE)}
    assert guessed(tree({**many, "z.ipynb": notebook("import tabulate", printed=notebooks.LARGE)})) == {"ikpy"}


LIBRARY = {
    "pyproject.toml": "[project]\nname = 'swing'\nversion = '1'\ndependencies = ['numpy']\n",
    "swing/__init__.py": "import numpy\n",
}
NAMED = "# Swing\n\nThe notebook `lesson/a.ipynb` shows the plots.\n"


@pytest.mark.parametrize(
    ("page", "place", "names"),
    [
        ({"README.md": NAMED}, "lesson/a.ipynb", {"ipywidgets"}),
        ({"README.md": "# Swing\n```\njupyter notebook lesson/a.ipynb\n```\n"}, "lesson/a.ipynb", {"ipywidgets"}),
        ({"README.md": "# Swing\n"}, "lesson/a.ipynb", set()),
        ({"README.md": NAMED}, "lesson/b.ipynb", set()),
        ({"lesson/README.md": "Open `lesson/a.ipynb`.\n"}, "lesson/a.ipynb", set()),
        ({"README.md": NAMED.replace("lesson", "tests")}, "tests/a.ipynb", set()),
    ],
)
def test_what_a_notebook_imports_is_needed_where_the_page_at_the_root_names_it(
    tree: Tree, page: dict[str, str], place: str, names: set[str]
) -> None:
    cells = notebook("import os", "import swing", "from ipywidgets import interact", "  import tabulate", "a = 1")
    assert guessed(tree({**LIBRARY, **page, place: cells})) == names


def test_what_another_notebook_has_first_is_needed_by_the_one_that_is_named(tree: Tree) -> None:
    cells = notebook("import ipywidgets", "a = 1")
    files = {"a.ipynb": cells, "lesson/a.ipynb": notebook("a = 1", "import ipywidgets")}
    found = tree({**LIBRARY, **files, "README.md": NAMED}).python.pip_guessed
    assert [each.file for each in found if each.name == "ipywidgets"] == ["lesson/a.ipynb"]
