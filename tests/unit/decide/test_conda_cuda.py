"""conda solves an environment for the GPU although the machine that builds has none."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


def _environment(*packages: str) -> dict[str, str]:
    lines = "".join(f"  - {package}\n" for package in ("python=3.8", *packages))
    return {"environment.yml": f"channels: [conda-forge]\ndependencies:\n{lines}", "run.py": "import torch\n"}


@pytest.mark.parametrize(
    ("packages", "cuda"),
    [
        (("pytorch=1.10.2", "cudatoolkit=11.3"), "11.3"),
        (("pytorch=2.1", "cuda-version=12.1"), "12.1"),
        (("numpy",), ""),
    ],
)
def test_conda_is_told_the_cuda_of_the_image(tree: Tree, packages: tuple[str, ...], cuda: str) -> None:
    decision = tree({**_environment(*packages), **({} if cuda else {"run.py": "import numpy\n"})})
    assert decision.python.manager == "conda"
    assert decision.python.conda_cuda == cuda


def test_a_newer_cuda_of_the_environment_is_what_its_packages_ask_for(tree: Tree) -> None:
    authored = {"docker/Dockerfile": "FROM nvidia/cuda:11.3.1-devel-ubuntu20.04\nRUN pip install torch==1.12.1+cu113\n"}
    decision = tree({**_environment("pytorch", "cuda-toolkit=12.1"), **authored})
    assert decision.python.conda_cuda == "12.1"


def test_pip_needs_none(tree: Tree) -> None:
    assert not tree({"requirements.txt": "torch==1.13.1\n"}).python.conda_cuda
