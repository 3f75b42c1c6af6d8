"""Which of the builds of a torch release pip takes: that of the command, and never the highest of all."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
ALL = "--find-links https://download.pytorch.org/whl/torch_stable.html"
SAID = "# Lab\n## Requirements\n- Python 3.7\n- pytorch==1.7.1\n"
RUN = "FROM nvidia/cuda:10.1-cudnn7-devel-ubuntu18.04\nCOPY . /lab\nRUN pip install {} -f " + ALL.partition(" ")[2]


@pytest.mark.parametrize(
    ("lines", "torch", "everything"),
    [
        ("torch==1.7.1+cu101 torchvision==0.8.2+cu101", "torch==1.7.1+cu101", True),
        ("torch==1.6.0+cu101 torchvision==0.7.0+cu101", "torch==1.7.1", True),
        ("torch==1.7.1", "torch==1.7.1", False),
    ],
)
def test_the_build_of_a_command_and_the_page_of_all(tree: Tree, lines: str, torch: str, everything: bool) -> None:
    files = {"README.md": SAID, "docker/Dockerfile": RUN.format(lines), "train.py": "import torch\n"}
    python = tree(files).python
    found = {each.written for each in (*python.pip, *python.pip_guessed) if each.key == "torch"}
    assert found == {torch}
    assert (ALL in python.options) is everything


def test_the_page_of_all_stays_where_torch_is_not_asked_for(tree: Tree) -> None:
    page = f"# Lab\n```\npip install scipy -f {ALL.partition(' ')[2]}\n```\n"
    assert ALL in tree({"README.md": page, "train.py": "import scipy\n"}).python.options
