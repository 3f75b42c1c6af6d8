"""A tensorflow in any version is one for the CUDA that a page installs, where the newest of its day is for another."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PAGE = "# Install\n```\nconda create -n a python={}\nconda install -c conda-forge cudatoolkit={}\npip install {}\n```\n"
CODE = "import tensorflow as tf\nprint(tf.constant(1))\n"


@pytest.mark.parametrize(
    ("python", "cuda", "asked", "bound"),
    [
        ("3.9", "11.2", "tensorflow", "tensorflow<2.12"),
        ("3.9", "11.2", "tensorflow==2.13", ""),
        ("3.9", "11.2", "tensorflow torch", ""),
        ("3.10", "11.8", "tensorflow", "tensorflow<2.15"),
        ("3.12", "11.2", "tensorflow", ""),
        ("3.12", "12.5", "tensorflow", ""),
    ],
)
def test_tensorflow(tree: Tree, python: str, cuda: str, asked: str, bound: str) -> None:
    decision = tree({"README.md": PAGE.format(python, cuda, asked), "run.py": CODE})
    found = [each.text for each in decision.python.bounds if each.key == "tensorflow" and not each.release]
    assert found == ([bound] if bound else [])


def test_tensorflow_without_a_stated_cuda(tree: Tree) -> None:
    decision = tree({"requirements.txt": "tensorflow\n", "run.py": CODE})
    assert not [each for each in decision.python.bounds if each.key == "tensorflow"]
