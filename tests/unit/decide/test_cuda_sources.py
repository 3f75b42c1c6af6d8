"""A package that pip compiles for a CUDA which its release does not know is told."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("asked", "told"),
    [
        ("cupy==7.1.1", "10.2"),
        ("cupy==6.5.0", "10.1"),
        ("cupy==7.8.0", "11.0"),
        ("cupy==8.6.0", ""),
        ("cupy>=7.1.1", ""),
        ("cupy-cuda111==8.6.0", ""),
    ],
)
def test_a_source_that_is_older_than_the_cuda_of_the_image(tree: Tree, asked: str, told: str) -> None:
    files = {"requirements.txt": f"torch==1.9.0+cu111\n{asked}\n", "main.py": "import torch\n"}
    decision = tree(files)
    assert decision.base_image.startswith("nvidia/cuda:11.1")
    found = [each for each in decision.warnings if "its source knows CUDA up to" in each.message]
    assert [(told in each.message, each.file, each.line) for each in found] == (
        [(True, "requirements.txt", 2)] if told else []
    )
