"""The Dockerfile of the project that a fork began with."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
IMAGE = """FROM pytorch/pytorch:1.6.0-cuda10.1-cudnn7-devel
RUN git clone https://github.com/{clone} /work
WORKDIR /work
RUN pip install --no-cache-dir -e .
"""
SAYS = "# Lab\n## Prerequisites\n- Python 3.7\n- CUDA 11.3\n"


@pytest.mark.parametrize(
    ("clone", "page", "cuda"),
    [
        ("open-mmlab/mmdetection3d.git", SAYS, "11.3"),
        ("open-mmlab/mmdetection3d.git", "# Lab\n", "11.0"),  # nothing else says one: the nearest to 10.1
        ("someone/helpers.git", SAYS, "11.0"),
    ],
)
def test_it_counts_less_than_a_page_of_the_fork(tree: Tree, clone: str, page: str, cuda: str) -> None:
    files = {
        "README.md": page,
        "setup.py": "from setuptools import setup\nsetup(name='mmdet3d', packages=['lab'])\n",
        "lab/__init__.py": "import torch\n",
        "docker/Dockerfile": IMAGE.format(clone=clone),
    }
    assert tree(files).cuda == cuda
