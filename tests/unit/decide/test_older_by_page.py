"""A page that installs an older version of what a manifest declares in any gets that version, after the manifest."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CODE = {"run.py": "import numpy\nimport gym\n"}


@pytest.mark.parametrize(
    ("declared", "page", "guessed"),
    [
        ("numpy\n", 'pip install "numpy<1.24"', ["numpy<1.24"]),
        ("numpy>=1.16\n", "pip install numpy==1.20", ["numpy==1.20"]),
        ("numpy<2\n", "pip install numpy==1.20", []),
        ("numpy\n", "pip install numpy>=1.16", []),
        ("numpy\n", "pip install numpy", []),
        ("torch\nnumpy\n", "pip install torch==1.10.0", []),
    ],
)
def test_what_a_page_holds_back(tree: Tree, declared: str, page: str, guessed: list[str]) -> None:
    files = {**CODE, "requirements.txt": f"{declared}gym==0.21\n", "README.md": f"```\n{page}\n```\n"}
    python = tree(files).python
    assert python.requirements == ("requirements.txt",)
    assert [each.written for each in python.pip_guessed if each.key in {"numpy", "torch"}] == guessed


@pytest.mark.parametrize(
    ("files", "version"),
    [
        ({"requirements.txt": "open3d-python\n"}, "3.7"),
        ({"tools/requirements.txt": "numpy\nopen3d-python\n"}, "3.7"),
        (
            {
                "requirements.txt": "tensorflow-addons\n",
                "pyproject.toml": "[project]\nname='a'\nrequires-python='>=3.11'\n",
            },
            "3.11",
        ),
        ({"requirements.txt": "numpy\n", "README.md": "```\npip install open3d-python\n```\n"}, "3.10"),
    ],
)
def test_a_package_that_ended_needs_a_python_of_its_time(tree: Tree, files: dict[str, str], version: str) -> None:
    code = {"run.py": "name = f'{1}'\nimport numpy\n"}
    assert tree(code | files).python.version == version


@pytest.mark.parametrize(
    ("declared", "guessed"),
    [("tensorflow-datasets\ntensorflow_hub\n", ["tensorflow==2.15.0"]), ("tensorflow-cpu\n", [])],
)
def test_what_is_named_after_tensorflow_does_not_bring_it(tree: Tree, declared: str, guessed: list[str]) -> None:
    page = "```\npip install tensorflow==2.15.0\npip install -r requirements.txt\n```\n"
    files = {"run.py": "import tensorflow as tf\n", "requirements.txt": declared, "README.md": page}
    python = tree(files).python
    assert [each.written for each in (*python.pip, *python.pip_guessed)] == guessed
